#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "base/vector.hpp"

namespace talus {

/// The smallest rotation that takes the direction `from` onto `to`, of any lengths, which are not opposite to each
/// other. Eigen's FromTwoVectors, which finds an axis for opposite ones too, compiles a singular value decomposition
/// into every file that calls it: ten seconds each.
inline Mat3 rotation_onto(const Vec3& from, const Vec3& to) {
  const Vec3 first = from.normalized(), second = to.normalized();
  const double s = std::sqrt((1 + second.dot(first)) * 2), inverse = 1 / s;
  Eigen::Quaterniond turn;
  turn.vec() = first.cross(second) * inverse;
  turn.w() = s * 0.5;
  return turn.toRotationMatrix();
}

}  // namespace talus
