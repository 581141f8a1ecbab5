#pragma once

#include <Eigen/Core>
#include <string_view>

#include "base/vector.hpp"

namespace talus {

using Vec2 = Eigen::Vector2d;

/// How the lower hemisphere is laid flat: Schmidt's net keeps areas, so that densities may be compared; Wulff's keeps
/// angles, so that circles on the sphere are circles on the net.
enum class Projection { equal_area, equal_angle };

constexpr std::string_view to_string(Projection projection) {
  return projection == Projection::equal_area ? "equal area" : "equal angle";
}

/// Where a unit vector lies on a net of radius 1: x east, y north, the downward vertical in the middle. A line that
/// points upwards lies outside the rim; `downward` turns it round. The upward vertical has no place (Wulff) or is a
/// circle of radius √2 (Schmidt, x > 0 is given).
Vec2 projected(const Vec3& line, Projection projection);

/// The unit vector at a place of the net; upward outside the rim. A place beyond Schmidt's circle of radius √2 counts
/// as one on it.
Vec3 unprojected(const Vec2& place, Projection projection);

}  // namespace talus
