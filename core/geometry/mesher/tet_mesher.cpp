#include "geometry/mesher/tet_mesher.hpp"

#include <gmsh.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
#include <unordered_map>

#include "base/error.hpp"

namespace talus {
namespace {

namespace mesh_api = gmsh::model::mesh;

constexpr int gmsh_triangle = 2, gmsh_tetrahedron = 4;
/// Faces of a tetrahedron of positive volume, counter-clockwise seen from outside.
constexpr std::array<std::array<int, 3>, 4> faces{{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

std::array<int, 3> sorted(std::array<int, 3> nodes) {
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

double six_volumes(const std::vector<Vec3>& nodes, const std::array<int, 4>& t) {
  const auto node = [&](int k) -> const Vec3& {
    return nodes[static_cast<std::size_t>(t[static_cast<std::size_t>(k)])];
  };
  return (node(1) - node(0)).cross(node(2) - node(0)).dot(node(3) - node(0));
}

/// gmsh's elements of one type on one entity. Output vectors that are not empty would be taken as allocated before.
std::vector<std::size_t> element_nodes(int type, int entity) {
  std::vector<std::size_t> elements, nodes;
  mesh_api::getElementsByType(type, elements, nodes, entity);
  return nodes;
}

/// Nodes numbered anew, in the order in which the tetrahedra name them.
std::unordered_map<std::size_t, int> take_tetrahedra(int volume, MeshedShape& shape) {
  std::vector<std::size_t> tags;
  std::vector<double> coordinates, parameters;
  mesh_api::getNodes(tags, coordinates, parameters, -1, -1, false, false);
  std::unordered_map<std::size_t, std::size_t> position;
  for (std::size_t i = 0; i < tags.size(); ++i) position.emplace(tags[i], 3 * i);
  std::unordered_map<std::size_t, int> number;
  const std::vector<std::size_t> named = element_nodes(gmsh_tetrahedron, volume);
  for (std::size_t i = 0; i + 3 < named.size(); i += 4) {
    std::array<int, 4> tetrahedron{};
    for (std::size_t k = 0; k < 4; ++k) {
      const auto [node, fresh] = number.try_emplace(named[i + k], static_cast<int>(shape.nodes.size()));
      if (fresh) {
        const std::size_t at = position.at(named[i + k]);
        shape.nodes.emplace_back(coordinates[at], coordinates[at + 1], coordinates[at + 2]);
      }
      tetrahedron[k] = node->second;
    }
    shape.tetrahedra.push_back(tetrahedron);
  }
  for (auto& tetrahedron : shape.tetrahedra) {
    if (six_volumes(shape.nodes, tetrahedron) < 0) std::swap(tetrahedron[2], tetrahedron[3]);
  }
  return number;
}

/// Faces that one tetrahedron alone has, in the order of the tetrahedra.
void take_surface(MeshedShape& shape) {
  std::map<std::array<int, 3>, int> uses;
  const auto face_of = [](const std::array<int, 4>& t, const std::array<int, 3>& f) {
    return std::array{t[static_cast<std::size_t>(f[0])], t[static_cast<std::size_t>(f[1])],
                      t[static_cast<std::size_t>(f[2])]};
  };
  for (const auto& t : shape.tetrahedra) {
    for (const auto& f : faces) ++uses[sorted(face_of(t, f))];
  }
  for (const auto& t : shape.tetrahedra) {
    for (const auto& f : faces) {
      if (uses.at(sorted(face_of(t, f))) == 1) shape.triangles.push_back(face_of(t, f));
    }
  }
}

/// Which face of the block each surface triangle is a piece of; 0 where gmsh's surface mesh lacks it.
std::vector<int> facet_tags(const CutBlock& block, const MeshedShape& shape,
                            const std::unordered_map<std::size_t, int>& number) {
  std::map<std::array<int, 3>, int> owner;
  for (const auto& [tag, origin] : block.facets) {
    const std::vector<std::size_t> named = element_nodes(gmsh_triangle, tag);
    for (std::size_t i = 0; i + 2 < named.size(); i += 3) {
      std::array<int, 3> triangle{};
      for (std::size_t k = 0; k < 3; ++k) {
        const auto node = number.find(named[i + k]);
        triangle[k] = node == number.end() ? -1 : node->second;
      }
      owner.emplace(sorted(triangle), tag);
    }
  }
  std::vector<int> tags;
  for (const auto& triangle : shape.triangles) {
    const auto found = owner.find(sorted(triangle));
    tags.push_back(found == owner.end() ? 0 : found->second);
  }
  return tags;
}

InputError not_meshed(const std::string& place, const std::string& why) {
  return InputError(place, "could not be meshed (" + why + ")",
                    "try another mesh_size, or move a cut that makes it thin");
}

/// A block whose edges are all shorter than the size aimed at needs no nodes but its corners; gmsh's default would
/// still put one into the middle of each face.
bool corners_suffice(const CutBlock& block, double size) {
  for (const auto& [tag, origin] : block.facets) {
    if (origin.plane < 0) return false;
    gmsh::vectorpair curves;
    gmsh::model::getBoundary({{2, tag}}, curves, false, false, false);
    for (const auto& [dimension, curve] : curves) {
      double length = 0;
      gmsh::model::occ::getMass(1, curve, length);
      constexpr double rounding = 1e-9;
      if (length > size * (1 + rounding)) return false;
    }
  }
  return true;
}

void generate(const CutBlock& block, double size, const std::string& place) {
  constexpr double initial_mesh_only = 3, frontal_delaunay = 6;
  gmsh::option::setNumber("Mesh.Algorithm", corners_suffice(block, size) ? initial_mesh_only : frontal_delaunay);
  gmsh::vectorpair everything;
  gmsh::model::getEntities(everything);
  gmsh::model::setVisibility(everything, 0);
  gmsh::model::setVisibility({{3, block.volume_tag}}, 1, true);
  mesh_api::clear();
  // A largest size alone would leave gmsh's own default, a tenth of the whole model, in force.
  gmsh::vectorpair corners;
  gmsh::model::getBoundary({{3, block.volume_tag}}, corners, false, false, true);
  mesh_api::setSize(corners, size);
  gmsh::option::setNumber("Mesh.MeshSizeMax", size);
  try {
    mesh_api::generate(3);
  } catch (const std::string& why) {
    throw not_meshed(place, why);
  }
}

}  // namespace

TetMesher::TetMesher(const PlaneTable& planes) : planes_(planes) {
  constexpr double delaunay = 1;
  gmsh::option::setNumber("Mesh.Algorithm3D", delaunay);
  gmsh::option::setNumber("Mesh.Optimize", 1);
  gmsh::option::setNumber("Mesh.MeshSizeMin", 0);
  gmsh::option::setNumber("Mesh.MeshOnlyVisible", 1);
  // An error in the threads of surface meshing would end the process; without an exception the checks below see it.
  gmsh::option::setNumber("General.AbortOnError", 0);
}

MeshedShape TetMesher::mesh(const CutBlock& block, double size, const std::string& place) {
  generate(block, size, place);
  MeshedShape shape;
  const auto number = take_tetrahedra(block.volume_tag, shape);
  if (shape.tetrahedra.empty()) {
    std::string why;
    gmsh::logger::getLastError(why);
    throw not_meshed(place, why.empty() ? "gmsh made no tetrahedra" : why);
  }
  take_surface(shape);

  const std::vector<int> tags = facet_tags(block, shape, number);
  std::vector<std::set<int>> node_planes(shape.nodes.size());
  bool flat = true;
  for (std::size_t i = 0; i < tags.size(); ++i) {
    if (tags[i] == 0) throw not_meshed(place, "its surface and its inside do not fit together");
    const FacetOrigin& origin = block.facets.at(tags[i]);
    shape.triangle_joints.push_back(origin.joint);
    flat = flat && origin.plane >= 0;
    if (origin.plane < 0) continue;
    for (int node : shape.triangles[i]) node_planes[static_cast<std::size_t>(node)].insert(origin.plane);
  }
  for (std::size_t node = 0; node < shape.nodes.size(); ++node) {
    std::vector<Plane> through;
    for (int plane : node_planes[node]) through.push_back(planes_[plane]);
    shape.nodes[node] = nearest_common_point(through, shape.nodes[node]);
  }

  double sum = 0;
  for (const auto& tetrahedron : shape.tetrahedra) {
    const double volume = six_volumes(shape.nodes, tetrahedron) / 6;
    if (!(volume > 0)) throw not_meshed(place, "a tetrahedron is flat or inside out");
    sum += volume;
  }
  constexpr double flat_allowed = 1e-9, curved_allowed = 0.05;
  if (std::abs(sum - block.volume) > (flat ? flat_allowed : curved_allowed) * block.volume) {
    std::ostringstream why;
    why.precision(12);
    why << "its tetrahedra fill " << sum << " m³ of " << block.volume << " m³";
    throw not_meshed(place, why.str());
  }
  return shape;
}

}  // namespace talus
