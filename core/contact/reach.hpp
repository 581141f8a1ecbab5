#pragma once

#include <vector>

#include "bodies/body_way.hpp"

namespace talus {

/// The gap up to which contacts of two bodies matter in a step: a length that is the same for all, and a multiple of
/// how far the two go against each other. Bodies that slide down side by side reach no farther than bodies at rest.
struct Reach {
  double least = 0;           ///< m
  double multiple = 0;        ///< –, of the ways
  std::vector<BodyWay> ways;  ///< a body; none: `least` is all

  Reach() = default;
  /// The same for any two bodies [m].
  Reach(double everywhere) : least(everywhere) {}

  /// Of two bodies. [m]
  double operator()(int body_a, int body_b) const {
    return ways.empty() ? least : least + multiple * against_each_other(ways[body_a], ways[body_b]);
  }
  /// One body's part: two reach no farther than their parts together. [m]
  double part(int body) const {
    return least / 2 + (ways.empty() ? 0 : multiple * (ways[body].mean.norm() + ways[body].beside));
  }

  void archive(auto& state) { state(least, multiple, ways); }
};

}  // namespace talus
