#include "geometry/mesher/tet_mesher.hpp"

#include <gmsh.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/error.hpp"
#include "geometry/mesher/sizes_in_force.hpp"

namespace talus {
namespace {

namespace mesh_api = gmsh::model::mesh;

constexpr int gmsh_triangle = 2, gmsh_tetrahedron = 4;
/// Faces of a tetrahedron of positive volume, counter-clockwise seen from outside.
constexpr std::array<std::array<std::size_t, 3>, 4> faces{{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

std::array<int, 3> face_of(const std::array<int, 4>& t, const std::array<std::size_t, 3>& face) {
  return {t[face[0]], t[face[1]], t[face[2]]};
}

std::array<int, 3> sorted(std::array<int, 3> nodes) {
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

double six_volumes(const std::vector<Vec3>& nodes, const std::array<int, 4>& t) {
  const auto node = [&](std::size_t k) -> const Vec3& { return nodes[static_cast<std::size_t>(t[k])]; };
  return (node(1) - node(0)).cross(node(2) - node(0)).dot(node(3) - node(0));
}

InputError not_meshed(const std::string& place, const std::string& why) {
  return InputError(place, "could not be meshed (" + why + ")",
                    "try another mesh_size, or move a cut that makes it thin");
}

/// Nodes and triangles of a closed part of a surface: its outside, or a cavity's.
struct ClosedPart {
  std::vector<std::size_t> node_tags, triangle_tags, named;
  std::vector<double> coordinates;
};

/// Node k of the surface has tag k + 1.
std::vector<ClosedPart> closed_parts_of(const SurfaceMesh& surface) {
  DisjointSets joined;
  joined.reset(static_cast<int>(surface.nodes.size()));
  for (const auto& [a, b, c] : surface.triangles) {
    joined.join(a, b);
    joined.join(b, c);
  }
  std::map<int, std::size_t> number;
  std::vector<ClosedPart> parts;
  const auto part_with = [&](int node) -> ClosedPart& {
    const auto [known, fresh] = number.try_emplace(joined.first_of(node), parts.size());
    if (fresh) parts.emplace_back();
    return parts[known->second];
  };
  for (std::size_t k = 0; k < surface.nodes.size(); ++k) {
    ClosedPart& part = part_with(static_cast<int>(k));
    part.node_tags.push_back(k + 1);
    part.coordinates.insert(part.coordinates.end(), surface.nodes[k].begin(), surface.nodes[k].end());
  }
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    ClosedPart& part = part_with(surface.triangles[i][0]);
    part.triangle_tags.push_back(i + 1);
    for (const int node : surface.triangles[i]) part.named.push_back(static_cast<std::size_t>(node) + 1);
  }
  return parts;
}

/// Makes the surface gmsh's current model. Each closed part is a face of its own: gmsh would fill cavities too.
void add_surface(const SurfaceMesh& surface) {
  gmsh::model::add("block");
  std::vector<int> loops;
  for (const ClosedPart& part : closed_parts_of(surface)) {
    const int face = static_cast<int>(loops.size()) + 1;
    gmsh::model::addDiscreteEntity(2, face);
    mesh_api::addNodes(2, face, part.node_tags, part.coordinates);
    mesh_api::addElementsByType(face, gmsh_triangle, part.triangle_tags, part.named);
    loops.push_back(gmsh::model::geo::addSurfaceLoop({face}, face));
  }
  gmsh::model::geo::addVolume(loops, 1);
  gmsh::model::geo::synchronize();
}

void generate(double size, std::span<const MeshRefinement> refinements) {
  constexpr double delaunay = 1;
  gmsh::option::setNumber("Mesh.Algorithm3D", delaunay);
  gmsh::option::setNumber("Mesh.Optimize", 1);
  const SizesInForce in_force(size, refinements);
  mesh_api::generate(3);
}

/// Tetrahedra and the nodes that they name; the surface's nodes come first, with the surface's own coordinates.
void take_tetrahedra(const SurfaceMesh& surface, MeshedShape& shape) {
  shape.nodes = surface.nodes;
  std::vector<std::size_t> tags, elements, named;
  std::vector<double> coordinates, parameters;
  mesh_api::getNodes(tags, coordinates, parameters, -1, -1, false, false);
  std::map<std::size_t, std::size_t> position;
  for (std::size_t i = 0; i < tags.size(); ++i) position.emplace(tags[i], 3 * i);
  std::map<std::size_t, int> inner;
  mesh_api::getElementsByType(gmsh_tetrahedron, elements, named);
  for (std::size_t i = 0; i + 3 < named.size(); i += 4) {
    std::array<int, 4> tetrahedron{};
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t tag = named[i + k];
      if (tag <= surface.nodes.size()) {
        tetrahedron[k] = static_cast<int>(tag) - 1;
        continue;
      }
      const auto [node, fresh] = inner.try_emplace(tag, static_cast<int>(shape.nodes.size()));
      if (fresh) {
        const std::size_t at = position.at(tag);
        shape.nodes.emplace_back(coordinates[at], coordinates[at + 1], coordinates[at + 2]);
      }
      tetrahedron[k] = node->second;
    }
    if (six_volumes(shape.nodes, tetrahedron) < 0) std::swap(tetrahedron[2], tetrahedron[3]);
    shape.tetrahedra.push_back(tetrahedron);
  }
}

/// Faces that one tetrahedron alone has, in the order of the tetrahedra: they must be the surface's triangles.
void take_surface(const SurfaceMesh& surface, MeshedShape& shape, const std::string& place) {
  std::map<std::array<int, 3>, int> joint, uses;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    joint.emplace(sorted(surface.triangles[i]), surface.origins[i].joint);
  }
  for (const auto& t : shape.tetrahedra) {
    for (const auto& face : faces) ++uses[sorted(face_of(t, face))];
  }
  for (const auto& t : shape.tetrahedra) {
    for (const auto& face : faces) {
      const auto triangle = face_of(t, face);
      if (uses.at(sorted(triangle)) > 1) continue;
      const auto known = joint.find(sorted(triangle));
      if (known == joint.end()) throw not_meshed(place, "its surface and its inside do not fit together");
      shape.triangles.push_back(triangle);
      shape.triangle_joints.push_back(known->second);
    }
  }
  if (shape.triangles.size() != surface.triangles.size()) throw not_meshed(place, "its surface is not closed");
}

/// What the last digits of a surface's nodes may cost: a thin plate has little volume for its area.
double volume_rounding(const SurfaceMesh& surface) {
  Eigen::AlignedBox3d bounds;
  for (const Vec3& node : surface.nodes) bounds.extend(node);
  double area = 0;
  for (const auto& triangle : surface.triangles) {
    const auto arm = [&](std::size_t k) -> Vec3 {
      return surface.nodes[static_cast<std::size_t>(triangle[k])] -
             surface.nodes[static_cast<std::size_t>(triangle[0])];
    };
    area += arm(1).cross(arm(2)).norm() / 2;
  }
  constexpr double rounding = 1e-12;
  return rounding * bounds.diagonal().norm() * area;
}

/// What its surface encloses [m³].
double enclosed_volume(const MeshedShape& shape) {
  const auto at = [&](int node) -> const Vec3& { return shape.nodes[static_cast<std::size_t>(node)]; };
  const Vec3& origin = shape.nodes.front();
  double sixfold = 0;
  for (const auto& [a, b, c] : shape.triangles) sixfold += (at(a) - origin).dot((at(b) - origin).cross(at(c) - origin));
  return sixfold / 6;
}

[[noreturn]] void refuse_volume(const std::string& what, double is, double volume, const std::string& place) {
  std::ostringstream why;
  why.precision(12);
  why << what << ' ' << is << " m³ of " << volume << " m³";
  throw not_meshed(place, why.str());
}

/// Tetrahedra fill their surface; the surface encloses the block, but for corners of it that are hardly any.
void check_volume(const MeshedShape& shape, const SurfaceMesh& surface, double volume, const std::string& place) {
  double sum = 0;
  for (const auto& tetrahedron : shape.tetrahedra) {
    const double part = six_volumes(shape.nodes, tetrahedron) / 6;
    if (!(part > 0)) throw not_meshed(place, "a tetrahedron is flat");
    sum += part;
  }
  constexpr double filled = 1e-9, flat_allowed = 1e-6, curved_allowed = 0.05;  // chords cut curved faces short
  const double rounding = volume_rounding(surface), enclosed = enclosed_volume(shape);
  if (std::abs(sum - enclosed) > filled * enclosed + rounding)
    refuse_volume("its tetrahedra fill", sum, enclosed, place);
  const bool flat = std::all_of(surface.origins.begin(), surface.origins.end(),
                                [](const FacetOrigin& origin) { return origin.plane >= 0; });
  if (std::abs(enclosed - volume) > (flat ? flat_allowed : curved_allowed) * volume + rounding)
    refuse_volume("its surface encloses", enclosed, volume, place);
}

}  // namespace

TouchesItself::TouchesItself(const std::string& place, const Vec3& at)
    : InputError(place, "touches itself along an edge",
                 "merge it with the block that fills the gap there, or move a cut that runs through the edge"),
      at_(at) {}

void require_two_triangles_an_edge(std::span<const Vec3> nodes, std::span<const std::array<int, 3>> triangles,
                                   const std::string& place) {
  std::map<std::pair<int, int>, int> uses;
  for (const auto& triangle : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const int one = triangle[k], other = triangle[(k + 1) % 3];
      if (++uses[std::minmax(one, other)] <= 2) continue;
      throw TouchesItself(place, (nodes[static_cast<std::size_t>(one)] + nodes[static_cast<std::size_t>(other)]) / 2);
    }
  }
}

MeshedShape fill_with_tetrahedra(const SurfaceMesh& surface, double size, std::span<const MeshRefinement> refinements,
                                 double volume, const std::string& place) {
  require_two_triangles_an_edge(surface.nodes, surface.triangles, place);
  MeshedShape shape;
  try {
    add_surface(surface);
    generate(size, refinements);
    take_tetrahedra(surface, shape);
    gmsh::model::remove();
  } catch (const std::string& why) {
    throw not_meshed(place, why);
  }
  if (shape.tetrahedra.empty()) {
    std::string why;
    gmsh::logger::getLastError(why);
    throw not_meshed(place, why.empty() ? "gmsh made no tetrahedra" : why);
  }
  take_surface(surface, shape, place);
  check_volume(shape, surface, volume, place);
  return shape;
}

}  // namespace talus
