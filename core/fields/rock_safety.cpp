#include "fields/rock_safety.hpp"

#include <algorithm>
#include <cmath>

#include "base/units.hpp"
#include "results/field.hpp"

namespace talus {

double rock_safety(const Voigt& stress, const RockStrength& strength) {
  const Vec3 principal = principal_stresses(stress);
  const double largest = -principal[2], smallest = -principal[0];  // compression positive
  const double slope = std::tan(radians(strength.friction_angle));
  const double left = strength.cohesion + smallest * slope;
  if (left < 0) return 0;  // pulled beyond the line's apex
  double safety = most_safety;
  const double shear = largest - smallest;
  const double strength_of_both = 2 * std::sqrt((strength.cohesion + largest * slope) * left);
  if (strength_of_both < safety * shear) safety = strength_of_both / shear;
  if (smallest < 0 && strength.tensile_strength) safety = std::min(safety, *strength.tensile_strength / -smallest);
  return safety;
}

}  // namespace talus
