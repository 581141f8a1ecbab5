#include "contact/contact_law.hpp"

#include <algorithm>

namespace talus {

double normal_force(const ContactPoint& point, double gap) {
  return std::max(-point.tension, point.multiplier - point.normal_stiffness * gap);
}

bool resists_elastically(const ContactPoint& point, double gap) {
  return point.multiplier - point.normal_stiffness * gap > -point.tension;
}

bool touches(const ContactPoint& point, double gap, double fraction) { return gap < fraction * point.size; }

double shear_strength(const ContactPoint& point, double normal_force) {
  return std::max(0.0, point.cohesion + point.friction * normal_force);
}

}  // namespace talus
