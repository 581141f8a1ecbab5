#include "model/rules/joint_rules.hpp"

#include "model/number_text.hpp"
#include "model/require.hpp"

namespace talus {

void check_friction_angle(double angle, const Place& place) {
  require_finite(angle, place);
  require(angle >= 0 && angle < 90, place,
          "the friction angle must be at least 0 and below 90, is " + number_text(angle), "give it in degrees");
}

void check(const Joint& joint, const Place& place) {
  check_friction_angle(joint.friction_angle, place / "friction_angle");
  require_not_negative(joint.cohesion, place / "cohesion", "cohesion", "Pa");
  require_not_negative(joint.tensile_strength, place / "tensile_strength", "tensile strength", "Pa");
  if (joint.residual_friction_angle) {
    check_friction_angle(*joint.residual_friction_angle, place / "residual_friction_angle");
    require(*joint.residual_friction_angle <= joint.friction_angle, place / "residual_friction_angle",
            "the residual friction angle, " + number_text(*joint.residual_friction_angle) +
                "°, exceeds the friction angle, " + number_text(joint.friction_angle) + "°",
            "give at most the friction angle, or leave it out");
  }
  if (joint.restitution) {
    require_finite(*joint.restitution, place / "restitution");
    require(*joint.restitution >= 0 && *joint.restitution <= 1, place / "restitution",
            "the restitution must be between 0 and 1, is " + number_text(*joint.restitution),
            "give the fraction of its speed with which a block leaves an impact, or leave it out");
  }
  if (joint.normal_stiffness) {
    require_positive(*joint.normal_stiffness, place / "normal_stiffness", "normal stiffness", "Pa/m");
  }
  if (joint.shear_stiffness) {
    require_positive(*joint.shear_stiffness, place / "shear_stiffness", "shear stiffness", "Pa/m");
  }
}

}  // namespace talus
