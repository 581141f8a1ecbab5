#include "verification/known_answers/wedges/wedge_equilibrium.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "base/units.hpp"

namespace talus {

double WedgeEquilibrium::factor(double friction_angle) const {
  return normal * std::tan(radians(friction_angle)) / driving;
}

double WedgeEquilibrium::critical_friction_angle() const { return degrees(std::atan2(driving, normal)); }

WedgeMode WedgeEquilibrium::mode(double friction_angle) const {
  return factor(friction_angle) >= 1 ? WedgeMode::stable : kinematic;
}

WedgeEquilibrium wedge_equilibrium(const WedgePlanes& planes, const Vec3& down) {
  const std::array away{planes.normals[0].dot(down), planes.normals[1].dot(down)};
  if (away[0] >= 0 && away[1] >= 0) return {WedgeMode::free_fall, down, 1, 0};

  constexpr std::array single{WedgeMode::plane_1, WedgeMode::plane_2};
  for (int i = 0; i < 2; ++i) {
    const Vec3 slide = down - away[i] * planes.normals[i];
    if (away[i] < 0 && slide.dot(planes.normals[1 - i]) >= 0)
      return {single[i], slide.normalized(), slide.norm(), -away[i]};
  }

  const double along = planes.line.dot(down);
  // down = along·line − N1·n1 − N2·n2, by the components across the line.
  const double cosine = planes.normals[0].dot(planes.normals[1]), sine2 = 1 - cosine * cosine;
  const double normal1 = (cosine * away[1] - away[0]) / sine2, normal2 = (cosine * away[0] - away[1]) / sine2;
  return {along > 0 ? WedgeMode::line_1 : WedgeMode::line_2, along > 0 ? planes.line : Vec3(-planes.line),
          std::abs(along), normal1 + normal2};
}

}  // namespace talus
