#pragma once

#include <span>
#include <string>

#include "orientation/attitude.hpp"

namespace talus {

/// The plane nearest to some points.
struct FittedPlane {
  PlaneAttitude plane;
  Vec3 through = Vec3::Zero();  ///< m, the mean of the points
  double deviation = 0;         ///< m, root mean square distance of the points from it
};

/// Least squares of the distances from the plane: through the mean, across the direction in which the points vary
/// least. Throws InputError, which names `place`, for fewer than three points and for points on one line.
FittedPlane fitted_plane(std::span<const Vec3> points, const std::string& place);

}  // namespace talus
