#pragma once

#include <cstddef>
#include <vector>

#include "bodies/block_pose.hpp"
#include "results/frame.hpp"

namespace talus {

/// The number, through all blocks, of each block's first node.
inline std::vector<std::size_t> first_nodes(const BlockSystem& system) {
  std::vector<std::size_t> first;
  std::size_t next = 0;
  for (const Block& block : system.blocks) {
    first.push_back(next);
    next += block.mesh.nodes.size();
  }
  return first;
}

/// Where each node of a block is, m; `first`: of `first_nodes`.
inline std::vector<Vec3> places(const Block& block, std::size_t first, const Frame& frame) {
  std::vector<Vec3> moved = block.mesh.nodes;
  for (std::size_t n = 0; n < moved.size(); ++n) moved[n] += frame.displacement[first + n];
  return moved;
}

}  // namespace talus
