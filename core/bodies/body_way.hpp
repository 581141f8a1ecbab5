#pragma once

#include "base/vector.hpp"

namespace talus {

/// How a body goes on in a step: as a whole, and the farthest that one of its nodes goes beside that.
struct BodyWay {
  Vec3 mean = Vec3::Zero();  ///< m
  double beside = 0;         ///< m

  void archive(auto& state) { state(mean, beside); }
};

/// No node of one body goes farther against one of the other. [m]
inline double against_each_other(const BodyWay& a, const BodyWay& b) {
  return (a.mean - b.mean).norm() + a.beside + b.beside;
}

}  // namespace talus
