#include "solve/step_corrections.hpp"

#include "solve/simulation_state.hpp"

namespace talus {

namespace {

bool update_normals(SimulationState& s) {
  if (!s.is_on(EffectKind::updated_normals)) return false;
  const EffectTimer timer(s.work_of(EffectKind::updated_normals));
  s.bodies.positions_after(s.increment, s.foreseen);
  const auto updated = [&](int point) { return s.detector.updated_normal(point, s.bodies.nodes.position, s.foreseen); };
  return s.normal_update.update(s.contacts, s.links, updated, s.increment, s.penetration(), s.detector.tolerances());
}

bool scale_penalty(SimulationState& s) {
  if (!s.is_on(EffectKind::penalty_scaling)) return false;
  const EffectTimer timer(s.work_of(EffectKind::penalty_scaling));
  const bool is_asked_for = s.project.solver.penetration_tolerance.has_value();
  const double by_spring = s.penetration();
  const double in_all = is_asked_for ? by_spring : s.tolerances.penalty_scaling.faces_in_all * by_spring;
  const auto as_given = is_asked_for ? std::span<const Joint>() : std::span<const Joint>(s.project.joints);
  return s.penalty_scaling.scale(s.contacts, s.links, s.increment, {by_spring, in_all}, as_given);
}

bool take_off(SimulationState& s) {
  if (!s.may_fly()) return false;
  const EffectTimer timer(s.work_of(EffectKind::acceleration_reset));
  if (!s.acceleration_reset.take_off(s.bodies, s.links, s.increment, s.penetration())) return false;
  s.open_close.begin_step(s.context);
  return true;
}

bool improve_multipliers(SimulationState& s) {
  if (multiplier_error(s.links, s.increment) <= s.penetration()) return false;
  adapt_multipliers(s.contacts, s.links, s.increment);
  return true;
}

}  // namespace

bool correct(SimulationState& s) {
  if (s.dynamic() && take_off(s)) return true;
  if (s.contacts.points.empty()) return false;
  if (s.multiplies()) return improve_multipliers(s);
  return (s.dynamic() && update_normals(s)) || scale_penalty(s);
}

}  // namespace talus
