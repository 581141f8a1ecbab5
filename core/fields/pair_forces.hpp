#pragma once

#include <array>
#include <span>
#include <vector>

#include "results/frame.hpp"

namespace talus {

/// What the contacts of two blocks come to together.
struct PairForce {
  std::array<int, 2> blocks{};
  Vec3 middle = Vec3::Zero();  ///< m, of the contact points, weighted by their normal forces
  Vec3 force = Vec3::Zero();   ///< N, on the first block
};

/// Of each two blocks that press on each other, in the order of their numbers. `places` of the contact points [m], one
/// each: where they are drawn.
std::vector<PairForce> pair_forces(const Frame& frame, std::span<const Vec3> places);

}  // namespace talus
