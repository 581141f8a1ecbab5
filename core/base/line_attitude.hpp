#pragma once

#include <cmath>

#include "base/units.hpp"
#include "base/vector.hpp"

namespace talus {

/// The attitude of a directed line as geologists write it, in degrees.
struct LineAttitude {
  double trend = 0;   ///< 0 … 360, clockwise from north (+y); 0 for a vertical line
  double plunge = 0;  ///< −90 … 90, downwards positive
};

/// `direction`: x east, y north, z up; of any length but zero.
inline LineAttitude attitude_of(const Vec3& direction) {
  const double level = std::hypot(direction.x(), direction.y());
  const double trend = level > 0 ? degrees(std::atan2(direction.x(), direction.y())) : 0;
  return {trend < 0 ? trend + 360 : trend, degrees(std::atan2(-direction.z(), level))};
}

}  // namespace talus
