#pragma once

#include <limits>

#include "base/vector.hpp"

namespace talus {

/// An axis-parallel box.
struct Box {
  Vec3 lower = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 upper = Vec3::Constant(-std::numeric_limits<double>::infinity());

  void add(const Vec3& p) {
    lower = lower.cwiseMin(p);
    upper = upper.cwiseMax(p);
  }
  void add(const Box& b) {
    lower = lower.cwiseMin(b.lower);
    upper = upper.cwiseMax(b.upper);
  }
  void widen(double margin) {
    lower.array() -= margin;
    upper.array() += margin;
  }
  /// How far apart the boxes are along the axis that parts them most; negative where they overlap.
  double apart(const Box& b) const { return (lower - b.upper).cwiseMax(b.lower - upper).maxCoeff(); }
  /// Whether no axis separates the boxes by more than `distance`.
  bool within(const Box& b, double distance) const {
    for (int k = 0; k < 3; ++k) {
      if (lower[k] - b.upper[k] > distance || b.lower[k] - upper[k] > distance) return false;
    }
    return true;
  }
};

}  // namespace talus
