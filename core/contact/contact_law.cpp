#include "contact/contact_law.hpp"

#include <algorithm>

namespace talus {

double normal_force(const ContactPoint& point, double gap) {
  return std::max(-point.tension, point.multiplier - point.normal_stiffness * gap);
}

double normal_spring_energy(const ContactPoint& point, double normal_force) {
  if (normal_force == 0 || point.let_go) return 0;
  const double compression = (normal_force - point.multiplier) / point.normal_stiffness;
  return 0.5 * point.normal_stiffness * compression * compression;
}

double shear_spring_energy(const ContactPoint& point, const Vec3& shear_force) {
  return shear_force.isZero(0) ? 0 : shear_force.squaredNorm() / (2 * point.shear_stiffness);
}

double spring_energy(const ContactPoint& point, const ContactOutcome& outcome) {
  return normal_spring_energy(point, outcome.normal_force) + shear_spring_energy(point, outcome.shear_force);
}

bool resists_elastically(const ContactPoint& point, double gap) {
  return point.multiplier - point.normal_stiffness * gap > -point.tension;
}

bool touches(const ContactPoint& point, double gap, double fraction) { return gap < fraction * point.size; }

double shear_strength(const ContactPoint& point, double normal_force) {
  return std::max(0.0, point.cohesion + point.friction * normal_force);
}

}  // namespace talus
