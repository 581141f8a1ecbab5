#pragma once

#include <algorithm>

#include "base/vector.hpp"

namespace talus {

/// How a body goes on in a step: as a whole, and the farthest that one of its nodes goes beside that.
struct BodyWay {
  Vec3 mean = Vec3::Zero();  ///< m
  double beside = 0;         ///< m

  void archive(auto& state) { state(mean, beside); }
};

/// Of a body whose nodes, so many from `first` on, go motion(node) each [m].
template <class Motion>
BodyWay way_of(int first, int nodes, const Motion& motion) {
  BodyWay way;
  for (int n = first; n < first + nodes; ++n) way.mean += motion(n) / nodes;
  for (int n = first; n < first + nodes; ++n) way.beside = std::max(way.beside, (motion(n) - way.mean).norm());
  return way;
}

/// No node of one body goes farther against one of the other. [m]
inline double against_each_other(const BodyWay& a, const BodyWay& b) {
  return (a.mean - b.mean).norm() + a.beside + b.beside;
}

}  // namespace talus
