#pragma once

#include <array>

#include "mesh/block.hpp"

namespace talus::test {

/// The six tetrahedra of a box (Kuhn's split), outward surface triangles, no joint.
inline Block box_block(const std::string& name, const Vec3& min, const Vec3& max,
                       BodyKind body = BodyKind::tetrahedra) {
  Block block;
  block.name = name;
  block.body = body;
  for (int i = 0; i < 8; ++i)
    block.mesh.nodes.emplace_back(i & 1 ? max.x() : min.x(), i & 2 ? max.y() : min.y(), i & 4 ? max.z() : min.z());
  constexpr int orders[6][3] = {{1, 2, 4}, {1, 4, 2}, {2, 1, 4}, {2, 4, 1}, {4, 1, 2}, {4, 2, 1}};
  for (int o = 0; o < 6; ++o) {
    std::array<int, 4> t{0, orders[o][0], orders[o][0] + orders[o][1], 7};
    if (o == 1 || o == 2 || o == 5) std::swap(t[1], t[2]);  // odd permutations are mirrored
    block.mesh.tetrahedra.push_back(t);
  }
  constexpr int faces[12][3] = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                                {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
  for (const auto& f : faces) block.surface.push_back({{f[0], f[1], f[2]}, -1});
  block.volume = (max - min).prod();
  return block;
}

}  // namespace talus::test
