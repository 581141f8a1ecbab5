#include "orientation/joint_outline.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "orientation/attitude.hpp"

namespace talus {
namespace {

std::vector<Vec3> polygon_of(const Disc& disc, const PlaneAttitude& plane) {
  const Vec3 down = dip_vector_of(plane), along = pole_of(plane).cross(down);
  const double step = 2 * std::numbers::pi / sides_of_disc, radius = disc.radius * std::sqrt(step / std::sin(step));
  std::vector<Vec3> corners;
  for (int i = 0; i < sides_of_disc; ++i)
    corners.push_back(disc.centre + radius * (std::cos(i * step) * along + std::sin(i * step) * down));
  return corners;
}

}  // namespace

std::vector<Vec3> outline_of(const Cut& joint) {
  const PlaneAttitude plane{joint.dip, joint.dip_direction};
  if (joint.disc) return polygon_of(*joint.disc, plane);
  const Vec3 normal = pole_of(plane);
  std::vector<Vec3> corners = joint.polygon;
  for (Vec3& corner : corners) corner -= normal.dot(corner - joint.through) * normal;
  return corners;
}

}  // namespace talus
