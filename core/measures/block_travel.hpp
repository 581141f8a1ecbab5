#pragma once

#include <vector>

#include "results/frame.hpp"

namespace talus {

struct BlockSystem;

/// How a block has moved up to a frame.
struct BlockTravel {
  int block = 0;
  Vec3 centroid = Vec3::Zero();      ///< m, where it is
  Vec3 displacement = Vec3::Zero();  ///< m, of the centroid
  Vec3 velocity = Vec3::Zero();      ///< m/s, of the centroid
  Mat3 rotation = Mat3::Identity();  ///< since the start, that of least squares where the block deforms

  double turn() const;  ///< degrees, 0 to 180
};

/// One a block, in their order. A block that is built fixed does not turn.
std::vector<BlockTravel> block_travels(const BlockSystem& system, const Frame& frame);

}  // namespace talus
