#include "geometry/mesher/surface_mesher.hpp"

#include <gmsh.h>

#include <algorithm>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

#include "geometry/mesher/sizes_in_force.hpp"
#include "mesh/size_field.hpp"

namespace talus {
namespace {

namespace mesh_api = gmsh::model::mesh;

/// A block whose edges are all shorter than the size aimed at needs no nodes but its corners; gmsh's default would
/// still put one into the middle of each face.
bool corners_suffice(const CutBlock& block, double size) {
  for (const auto& [tag, facet] : block.facets) {
    if (facet.origin.plane < 0) return false;
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

/// What blocks that are meshed in one go have in common.
struct Manner {
  double size = 0;
  bool corners_only = false, refined = false;
  auto operator<=>(const Manner&) const = default;
};

void set_sizes_at_corners(const gmsh::vectorpair& volumes, double size, std::span<const MeshRefinement> refinements) {
  gmsh::vectorpair corners;
  gmsh::model::getBoundary(volumes, corners, false, false, true);
  if (refinements.empty()) return mesh_api::setSize(corners, size);
  for (const auto& corner : corners) {
    std::vector<double> at;
    gmsh::model::getValue(corner.first, corner.second, {}, at);
    mesh_api::setSize({corner}, size_at({at[0], at[1], at[2]}, size, refinements));
  }
}

void generate(const Manner& manner, const gmsh::vectorpair& volumes, std::span<const MeshRefinement> refinements) {
  constexpr double initial_mesh_only = 3, frontal_delaunay = 6;
  gmsh::vectorpair everything;
  gmsh::model::getEntities(everything);
  gmsh::model::setVisibility(everything, 0);
  gmsh::model::setVisibility(volumes, 1, true);
  mesh_api::clear();
  // A largest size alone would leave gmsh's own default, a tenth of the whole model, in force.
  set_sizes_at_corners(volumes, manner.size, refinements);
  const SizesInForce in_force(manner.size, refinements);
  gmsh::option::setNumber("Mesh.Algorithm", manner.corners_only ? initial_mesh_only : frontal_delaunay);
  gmsh::option::setNumber("Mesh.MeshOnlyVisible", 1);
  mesh_api::generate(2);
  gmsh::option::setNumber("Mesh.MeshOnlyVisible", 0);
}

/// Coordinates of all nodes by gmsh's tags.
std::unordered_map<std::size_t, Vec3> all_nodes() {
  std::vector<std::size_t> tags;
  std::vector<double> coordinates, parameters;
  mesh_api::getNodes(tags, coordinates, parameters, -1, -1, false, false);
  std::unordered_map<std::size_t, Vec3> nodes;
  for (std::size_t i = 0; i < tags.size(); ++i) {
    nodes.emplace(tags[i], Vec3(coordinates[3 * i], coordinates[3 * i + 1], coordinates[3 * i + 2]));
  }
  return nodes;
}

SurfaceMesh take_surface(const CutBlock& block, const std::unordered_map<std::size_t, Vec3>& nodes) {
  constexpr int gmsh_triangle = 2;
  SurfaceMesh surface;
  std::unordered_map<std::size_t, int> number;
  for (const auto& [tag, facet] : block.facets) {
    // gmsh would take vectors that are not empty as allocated before: they must be new each time.
    std::vector<std::size_t> elements, named;
    mesh_api::getElementsByType(gmsh_triangle, elements, named, tag);
    for (std::size_t i = 0; i + 2 < named.size(); i += 3) {
      std::array<int, 3> triangle{};
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [node, fresh] = number.try_emplace(named[i + k], static_cast<int>(surface.nodes.size()));
        if (fresh) surface.nodes.push_back(nodes.at(named[i + k]));
        triangle[k] = node->second;
      }
      surface.triangles.push_back(triangle);
      surface.origins.push_back(facet.origin);
    }
  }
  return surface;
}

void put_onto_planes(SurfaceMesh& surface, const PlaneTable& planes) {
  std::vector<std::set<int>> through(surface.nodes.size());
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    const int plane = surface.origins[i].plane;
    if (plane < 0) continue;
    for (int node : surface.triangles[i]) through[static_cast<std::size_t>(node)].insert(plane);
  }
  for (std::size_t node = 0; node < through.size(); ++node) {
    std::vector<Plane> meeting;
    for (int plane : through[node]) meeting.push_back(planes[plane]);
    surface.nodes[node] = nearest_common_point(meeting, surface.nodes[node]);
  }
}

using SizeKey = std::pair<double, bool>;  ///< m; refined

/// Of each solid, by its index: how most of its blocks are meshed; of as many, the larger.
std::map<int, SizeKey> usual_sizes(std::span<const NamedBlock> blocks, std::span<const MesherSize> sizes) {
  std::map<int, std::map<SizeKey, int>> counts;
  for (std::size_t b = 0; b < blocks.size(); ++b) ++counts[blocks[b].shape.solid][{sizes[b].size, sizes[b].refined}];
  std::map<int, SizeKey> usual;
  for (const auto& [solid, count] : counts) {
    const auto fewer = [](const auto& a, const auto& c) { return a.second <= c.second; };
    usual[solid] = std::max_element(count.begin(), count.end(), fewer)->first;
  }
  return usual;
}

}  // namespace

std::vector<SurfaceMesh> mesh_surfaces(std::span<const NamedBlock> blocks, const PlaneTable& planes,
                                       std::span<const MesherSize> sizes, std::span<const MeshRefinement> refinements) {
  std::map<Manner, std::vector<std::size_t>> groups;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    if (blocks[b].shape.volume_tags.empty()) continue;
    const auto& [size, refined] = sizes[b];
    const bool corners_only = !refined && corners_suffice(blocks[b].shape, size);
    groups[{size, corners_only, refined}].push_back(b);
  }
  const std::map<int, SizeKey> usual = usual_sizes(blocks, sizes);
  std::vector<SurfaceMesh> surfaces(blocks.size());
  for (const auto& [manner, members] : groups) {
    // Where in gmsh's chance a face comes depends on all that are meshed with it: a solid's usual size is that of all
    // of it, or the neighbours of a block that gets its own would have other triangles than before.
    std::set<std::size_t> together(members.begin(), members.end());
    for (std::size_t b = 0; b < blocks.size(); ++b)
      if (usual.at(blocks[b].shape.solid) == SizeKey(manner.size, manner.refined)) together.insert(b);
    gmsh::vectorpair volumes;
    for (std::size_t b : together)
      for (int tag : blocks[b].shape.volume_tags) volumes.emplace_back(3, tag);
    generate(manner, volumes, manner.refined ? refinements : std::span<const MeshRefinement>());
    const auto nodes = all_nodes();
    for (std::size_t b : members) {
      surfaces[b] = take_surface(blocks[b].shape, nodes);
      put_onto_planes(surfaces[b], planes);
    }
  }
  return surfaces;
}

}  // namespace talus
