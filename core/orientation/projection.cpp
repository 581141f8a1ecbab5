#include "orientation/projection.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace talus {

Vec2 projected(const Vec3& line, Projection projection) {
  const Vec2 level(line.x(), line.y());
  const double width = level.norm();
  const double half_angle = std::atan2(width, -line.z()) / 2;  // from the downward vertical
  const double radius =
      projection == Projection::equal_area ? std::numbers::sqrt2 * std::sin(half_angle) : std::tan(half_angle);
  return width > 0 ? Vec2(level * (radius / width)) : Vec2(radius > 0.5 ? radius : 0, 0);
}

Vec3 unprojected(const Vec2& place, Projection projection) {
  const double radius = place.norm();
  const double half_angle =
      projection == Projection::equal_area ? std::asin(std::min(1.0, radius / std::numbers::sqrt2)) : std::atan(radius);
  const Vec2 level = radius > 0 ? Vec2(place / radius * std::sin(2 * half_angle)) : Vec2(0, 0);
  return {level.x(), level.y(), -std::cos(2 * half_angle)};
}

}  // namespace talus
