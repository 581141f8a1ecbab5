#include "verification/known_answers/continuum/slipping_joint.hpp"

#include <cmath>

#include "base/units.hpp"

namespace talus {

namespace {

const double inclination = radians(45);

}  // namespace

double SlippingJoint::first_unloading() const {
  const double joint_length = width / std::cos(inclination);
  return 1 / (height / (width * young) + 1 / (stiffness * joint_length));
}

double SlippingJoint::with_slip(int direction) const {
  const double joint_length = width / std::cos(inclination), friction = radians(friction_angle);
  const double k = first_unloading();
  return k / (1 + k * std::sin(inclination) * std::sin(inclination + direction * friction) /
                      (stiffness * (joint_length - slipping_length) * std::cos(friction)));
}

double SlippingJoint::loading() const { return with_slip(-1); }
double SlippingJoint::last_unloading() const { return with_slip(1); }

}  // namespace talus
