#pragma once

#include <string_view>

namespace talus {

/// What a scene can call for: the terms of the potential; rebound, which acts on velocities once a step is taken; and
/// what else costs and can be left out, which is no term of the potential either.
enum class EffectKind {
  elasticity,
  neo_hookean_elasticity,
  initial_stress,
  inertia,
  displacement_constraint,
  point_load,
  body_force,
  normal_contact,
  shear_contact,
  cohesion_and_tension,
  rebound,
  damping,
  restitution,
  missed_contacts,
  updated_normals,
  penalty_scaling,
  followed_springs,
  acceleration_reset,
  sleep,
  elimination
};
inline constexpr int effect_kinds = static_cast<int>(EffectKind::elimination) + 1;

/// The name that users read, in tables and in summary.json.
constexpr std::string_view to_string(EffectKind kind) {
  switch (kind) {
    case EffectKind::elasticity:
      return "elasticity";
    case EffectKind::neo_hookean_elasticity:
      return "neo-Hookean elasticity";
    case EffectKind::initial_stress:
      return "initial stress";
    case EffectKind::inertia:
      return "inertia";
    case EffectKind::displacement_constraint:
      return "displacement constraint";
    case EffectKind::point_load:
      return "point load";
    case EffectKind::body_force:
      return "body force";
    case EffectKind::normal_contact:
      return "normal contact";
    case EffectKind::shear_contact:
      return "shear contact";
    case EffectKind::cohesion_and_tension:
      return "cohesion and tension";
    case EffectKind::rebound:
      return "rebound";
    case EffectKind::damping:
      return "damping";
    case EffectKind::restitution:
      return "restitution";
    case EffectKind::missed_contacts:
      return "missed contacts";
    case EffectKind::updated_normals:
      return "updated normals";
    case EffectKind::penalty_scaling:
      return "penalty scaling";
    case EffectKind::followed_springs:
      return "followed springs";
    case EffectKind::acceleration_reset:
      return "acceleration reset";
    case EffectKind::sleep:
      return "sleep";
    case EffectKind::elimination:
      break;
  }
  return "nonlinear elimination";
}

}  // namespace talus
