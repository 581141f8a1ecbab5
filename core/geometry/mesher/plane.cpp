#include "geometry/mesher/plane.hpp"

#include <Eigen/Dense>
#include <cmath>

#include "base/units.hpp"

namespace talus {

Vec3 cleaned_direction(Vec3 direction) {
  constexpr double rounding = 1e-15;
  for (double& component : direction) {
    if (std::abs(component) < rounding) component = 0;
  }
  return direction.normalized();
}

Vec3 upward_normal(double dip, double dip_direction) {
  const double tilt = radians(dip), azimuth = radians(dip_direction);
  return cleaned_direction({std::sin(tilt) * std::sin(azimuth), std::sin(tilt) * std::cos(azimuth), std::cos(tilt)});
}

double angle_between(const Plane& a, const Plane& b) {
  // The arc tangent stays exact for the small angles this is asked about; an arc cosine would not.
  return std::atan2(a.normal.cross(b.normal).norm(), std::abs(a.normal.dot(b.normal)));
}

Vec3 nearest_common_point(std::span<const Plane> planes, const Vec3& point) {
  if (planes.empty()) return point;
  // Below this sine two planes count as one: their line of intersection would be far off and meaningless.
  constexpr double same_direction = 1e-6;
  Eigen::Matrix<double, Eigen::Dynamic, 3> normals(static_cast<Eigen::Index>(planes.size()), 3);
  for (std::size_t i = 0; i < planes.size(); ++i) {
    normals.row(static_cast<Eigen::Index>(i)) = planes[i].normal.transpose();
  }
  Eigen::JacobiSVD<Eigen::MatrixXd> solver(normals, Eigen::ComputeThinU | Eigen::ComputeThinV);
  solver.setThreshold(same_direction);
  Vec3 nearest = point;
  Eigen::VectorXd misses(normals.rows());
  for (int pass = 0; pass < 2; ++pass) {  // the second takes away the rounding of the first
    for (std::size_t i = 0; i < planes.size(); ++i) misses[static_cast<Eigen::Index>(i)] = planes[i].distance(nearest);
    nearest -= solver.solve(misses);
  }
  return nearest;
}

}  // namespace talus
