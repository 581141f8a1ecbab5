#include "orientation/fitted_plane.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "base/error.hpp"

namespace talus {

FittedPlane fitted_plane(std::span<const Vec3> points, const std::string& place) {
  constexpr double thinnest = 1e-4;  // width over length of points that still span a plane
  if (points.size() < 3) throw InputError(place, "fewer than three points span no plane", "give three or more");
  Vec3 mean = Vec3::Zero();
  for (const Vec3& point : points) mean += point / static_cast<double>(points.size());
  Mat3 scatter = Mat3::Zero();
  for (const Vec3& point : points) scatter += (point - mean) * (point - mean).transpose();
  Eigen::SelfAdjointEigenSolver<Mat3> directions;
  directions.computeDirect(scatter);  // ascending
  const Vec3 squares = directions.eigenvalues().cwiseMax(0);
  if (squares[1] <= thinnest * thinnest * squares[2])
    throw InputError(place, "the points lie on one line: they span no plane", "give points that are apart");
  return {attitude_of_normal(directions.eigenvectors().col(0)), mean,
          std::sqrt(squares[0] / static_cast<double>(points.size()))};
}

}  // namespace talus
