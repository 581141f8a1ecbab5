#pragma once

#include <span>

#include "base/vector.hpp"

namespace talus {

/// The points x with normal · x = offset; the normal has unit length.
struct Plane {
  Vec3 normal = Vec3::UnitZ();
  double offset = 0;  ///< m

  double distance(const Vec3& point) const { return normal.dot(point) - offset; }
};

/// Unit vector; components that are zero but for rounding are made zero: a vertical or level plane stays exactly so.
Vec3 cleaned_direction(Vec3 direction);

/// Upward unit normal of a plane; dip from the horizontal, dip direction clockwise from north (+y), in degrees.
Vec3 upward_normal(double dip, double dip_direction);

/// Acute angle between two planes, radians.
double angle_between(const Plane& a, const Plane& b);

/// The point of the planes' intersection (a plane, line or point) nearest to `point`; planes that differ by rounding
/// alone count once. Where the planes have no common point, the one that misses them least.
Vec3 nearest_common_point(std::span<const Plane> planes, const Vec3& point);

}  // namespace talus
