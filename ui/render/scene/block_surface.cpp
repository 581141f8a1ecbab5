#include "render/scene/block_surface.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/units.hpp"

namespace talus {
namespace {

using Triple = std::array<int, 3>;

Triple sorted(Triple nodes) {
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

/// Faces of the tetrahedra that have all nodes on the surface, each with a tetrahedron it belongs to.
std::map<Triple, int> tetrahedra_behind(const Block& block) {
  std::map<Triple, int> behind;
  for (const SurfaceTriangle& triangle : block.surface) behind[sorted(triangle.nodes)] = -1;
  for (std::size_t t = 0; t < block.mesh.tetrahedra.size(); ++t) {
    const auto& n = block.mesh.tetrahedra[t];
    for (const Triple& face : {Triple{n[0], n[1], n[2]}, {n[0], n[1], n[3]}, {n[0], n[2], n[3]}, {n[1], n[2], n[3]}})
      if (const auto found = behind.find(sorted(face)); found != behind.end()) found->second = static_cast<int>(t);
  }
  return behind;
}

Vec3 unit_normal(const Block& block, const SurfaceTriangle& triangle) {
  const Vec3& a = block.mesh.nodes[triangle.nodes[0]];
  const Vec3& b = block.mesh.nodes[triangle.nodes[1]];
  const Vec3& c = block.mesh.nodes[triangle.nodes[2]];
  return (b - a).cross(c - a).normalized();
}

/// An edge of a block, and how far its surface bends there.
struct Bend {
  std::array<int, 2> nodes;
  bool sharp = false, strong = false;
};

/// A slight bend is an edge where it goes on at both ends: on rough ground single ones are no lines but specks.
void leave_loose_ends_out(std::vector<Bend>& bends, std::size_t node_count) {
  std::vector<std::vector<std::size_t>> at(node_count);
  for (std::size_t i = 0; i < bends.size(); ++i)
    if (bends[i].sharp)
      for (const int node : bends[i].nodes) at[static_cast<std::size_t>(node)].push_back(i);
  std::vector<std::size_t> loose;
  const auto look_at = [&](std::size_t node) {
    if (at[node].size() == 1 && !bends[at[node].front()].strong) loose.push_back(at[node].front());
  };
  for (std::size_t node = 0; node < node_count; ++node) look_at(node);
  while (!loose.empty()) {
    const std::size_t edge = loose.back();
    loose.pop_back();
    if (!std::exchange(bends[edge].sharp, false)) continue;
    for (const int node : bends[edge].nodes) {
      std::erase(at[static_cast<std::size_t>(node)], edge);
      look_at(static_cast<std::size_t>(node));
    }
  }
}

void append_edges(const Block& block, int block_index, const std::vector<int>& vertex_of, BlockSurface& out) {
  const double bend = std::cos(radians(15)), strong_bend = std::cos(radians(40));
  std::map<std::array<int, 2>, std::vector<Vec3>> normals;
  for (const SurfaceTriangle& triangle : block.surface) {
    const Vec3 normal = unit_normal(block, triangle);
    for (int i = 0; i < 3; ++i) {
      const int a = triangle.nodes[i], b = triangle.nodes[(i + 1) % 3];
      normals[{std::min(a, b), std::max(a, b)}].push_back(normal);
    }
  }
  std::vector<Bend> bends;
  for (const auto& [nodes, sides] : normals) {
    const double straight = sides.size() == 2 ? sides[0].dot(sides[1]) : -1;
    bends.push_back({nodes, straight < bend, straight < strong_bend});
  }
  leave_loose_ends_out(bends, block.mesh.nodes.size());
  for (const Bend& one : bends)
    out.edges.push_back({{vertex_of[one.nodes[0]], vertex_of[one.nodes[1]]}, block_index, one.sharp});
}

void append_block(const Block& block, int block_index, int first_node, int first_tetrahedron, BlockSurface& out) {
  std::vector<int> vertex_of(block.mesh.nodes.size(), -1);
  const std::map<Triple, int> behind = tetrahedra_behind(block);
  for (std::size_t facet = 0; facet < block.surface.size(); ++facet) {
    const SurfaceTriangle& triangle = block.surface[facet];
    BlockSurface::Triangle drawn{.vertices = {},
                                 .block = block_index,
                                 .tetrahedron = behind.at(sorted(triangle.nodes)),
                                 .facet = static_cast<int>(facet)};
    if (drawn.tetrahedron >= 0) drawn.tetrahedron += first_tetrahedron;
    for (int i = 0; i < 3; ++i) {
      const int node = triangle.nodes[i];
      if (vertex_of[node] < 0) {
        vertex_of[node] = static_cast<int>(out.nodes.size());
        out.nodes.push_back(first_node + node);
        out.rest.push_back(block.mesh.nodes[node]);
      }
      drawn.vertices[i] = vertex_of[node];
    }
    out.triangles.push_back(drawn);
  }
  append_edges(block, block_index, vertex_of, out);
}

}  // namespace

BlockSurface block_surface(const BlockSystem& system, const std::vector<bool>& wanted) {
  BlockSurface out;
  const auto begin = [&] {
    out.begins.push_back({static_cast<int>(out.nodes.size()), static_cast<int>(out.triangles.size()),
                          static_cast<int>(out.edges.size())});
  };
  int first_node = 0, first_tetrahedron = 0;
  for (std::size_t b = 0; b < system.blocks.size(); ++b) {
    const Block& block = system.blocks[b];
    begin();
    if (wanted[b]) append_block(block, static_cast<int>(b), first_node, first_tetrahedron, out);
    first_node += static_cast<int>(block.mesh.nodes.size());
    first_tetrahedron += static_cast<int>(block.mesh.tetrahedra.size());
  }
  begin();
  return out;
}

Eigen::AlignedBox3d bounds(const BlockSystem& system) {
  Eigen::AlignedBox3d box;
  for (const Block& block : system.blocks)
    for (const Vec3& node : block.mesh.nodes) box.extend(node);
  return box;
}

}  // namespace talus
