#pragma once

#include <vector>

#include "base/vector.hpp"

namespace talus {

struct BlockSystem;
struct Frame;

/// The line about which a block turns at a moment.
struct TurningAxis {
  int block = 0;
  Vec3 point = Vec3::Zero();      ///< m, of the line, the nearest to the block's middle
  Vec3 direction = Vec3::Zero();  ///< unit: it turns about it by the right hand
  double rate = 0;                ///< rad/s
  double size = 0;                ///< m, the largest distance of one of the block's nodes from its middle
};

/// Of blocks that turn in the frame: with the angular velocity ω and the velocity v that fit those of the nodes best,
/// about their middle c, the axis goes through c + ω × v / ω². Told are blocks whose axis lies no farther from their
/// middle than twice their size (one that mainly slides turns about a place far away), that turn at least at a
/// hundredth of the rate of the fastest, and that neither stand still, as their class of motion says, nor sleep.
/// Lengths are those of the frame, not of what is drawn.
std::vector<TurningAxis> turning_axes(const BlockSystem& system, const Frame& frame);

}  // namespace talus
