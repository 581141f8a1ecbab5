#include "verification/random/standing_dominoes.hpp"

#include <cmath>

#include "base/units.hpp"

namespace talus {

double StandingDominoes::tipping_angle() const { return degrees(std::atan2(thickness, height)); }

double StandingDominoes::leaning_angle() const { return degrees(std::asin(gap / height)); }

double StandingDominoes::tipping_spin() const {
  constexpr double gravity = 9.81;  // m/s²
  const double radius = std::hypot(thickness, height) / 2;
  return std::sqrt(3 * gravity * (radius - height / 2) / 2) / radius;
}

bool StandingDominoes::leaning_overturns(double friction, double share) const {
  const double sine = gap / height, cosine = std::sqrt(1 - sine * sine), mu = std::tan(radians(friction));
  // In units of the weight: what the leaning one presses with, then the moment of that on the next.
  const double press = (height * sine - thickness * cosine) / 2 / (height * (cosine + mu * sine));
  return press * (height * cosine - mu * thickness) > share * thickness / 2;
}

}  // namespace talus
