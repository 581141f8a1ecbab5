#include "geometry/mesher/mesh_file.hpp"

#include <gmsh.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <unordered_map>

#include "base/error.hpp"

namespace talus {
namespace {

namespace mesh_api = gmsh::model::mesh;

/// Node tags of all elements of a type (gmsh's numbers: 2 triangles, 3 quadrangles, 4 tetrahedra), `corners` each.
std::vector<std::vector<std::size_t>> elements(int type, std::size_t corners) {
  std::vector<std::size_t> tags, nodes;
  mesh_api::getElementsByType(type, tags, nodes);
  std::vector<std::vector<std::size_t>> found;
  for (std::size_t i = 0; i + corners <= nodes.size(); i += corners)
    found.emplace_back(nodes.begin() + static_cast<std::ptrdiff_t>(i),
                       nodes.begin() + static_cast<std::ptrdiff_t>(i + corners));
  return found;
}

/// Faces that one tetrahedron alone has.
std::vector<std::vector<std::size_t>> skin_of(const std::vector<std::vector<std::size_t>>& tetrahedra) {
  constexpr std::array<std::array<std::size_t, 3>, 4> sides{{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
  std::map<std::vector<std::size_t>, std::vector<std::size_t>> open;
  for (const auto& tetrahedron : tetrahedra)
    for (const auto& side : sides) {
      const std::vector<std::size_t> face{tetrahedron[side[0]], tetrahedron[side[1]], tetrahedron[side[2]]};
      std::vector<std::size_t> sorted = face;
      std::sort(sorted.begin(), sorted.end());
      if (!open.emplace(sorted, face).second) open.erase(sorted);
    }
  std::vector<std::vector<std::size_t>> skin;
  for (const auto& [sorted, face] : open) skin.push_back(face);
  return skin;
}

std::vector<std::vector<std::size_t>> faces_in_model() {
  std::vector<std::vector<std::size_t>> faces = skin_of(elements(4, 4));
  if (!faces.empty()) return faces;
  faces = elements(2, 3);
  for (auto& quadrangle : elements(3, 4)) faces.push_back(std::move(quadrangle));
  return faces;
}

/// With the nodes that the faces use, in the order in which they do.
PolygonSoup soup_of(const std::vector<std::vector<std::size_t>>& faces) {
  std::vector<std::size_t> tags;
  std::vector<double> coordinates, parameters;
  mesh_api::getNodes(tags, coordinates, parameters, -1, -1, false, false);
  std::unordered_map<std::size_t, std::size_t> place;
  for (std::size_t i = 0; i < tags.size(); ++i) place.emplace(tags[i], 3 * i);
  PolygonSoup soup;
  std::unordered_map<std::size_t, int> number;
  for (const auto& face : faces) {
    std::vector<int> polygon;
    for (const std::size_t tag : face) {
      const auto [node, fresh] = number.try_emplace(tag, static_cast<int>(soup.points.size()));
      const std::size_t at = place.at(tag);
      if (fresh) soup.points.emplace_back(coordinates[at], coordinates[at + 1], coordinates[at + 2]);
      polygon.push_back(node->second);
    }
    soup.polygons.push_back(std::move(polygon));
  }
  return soup;
}

/// gmsh takes what does not begin as a mesh for a script and would run it.
bool begins_as_mesh(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string first;
  file >> first;
  return first == "$MeshFormat" || first == "$Comments" || first == "$NOD";
}

}  // namespace

PolygonSoup read_mesh(const std::string& path, const std::string& as_written) {
  std::string before;
  gmsh::model::getCurrent(before);
  gmsh::model::add("mesh file");
  PolygonSoup soup;
  try {
    if (begins_as_mesh(path)) gmsh::merge(path);
    soup = soup_of(faces_in_model());
  } catch (const std::string&) {
    // What gmsh does not read has no faces.
  } catch (const std::out_of_range&) {
    soup = {};  // nodes are missing
  }
  gmsh::model::remove();
  gmsh::model::setCurrent(before);
  if (soup.polygons.empty())
    throw InputError(as_written, "is not a readable MSH file with tetrahedra, triangles or quadrangles",
                     "export the mesh again as MSH");
  return soup;
}

}  // namespace talus
