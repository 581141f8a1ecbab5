#include "solve/stage_start.hpp"

#include <algorithm>

#include "model/stage_changes.hpp"
#include "solve/awake_bodies.hpp"
#include "solve/contact_search.hpp"
#include "solve/dynamics/initial_motion.hpp"
#include "solve/joint_laws.hpp"
#include "solve/simulation_state.hpp"

namespace talus {

namespace {

/// Bodies on which a load or a constraint of the stage acts by table: one flag a body.
std::vector<bool> moved_by_table(const Project& now, const BlockSystem& system) {
  std::vector<bool> moved;
  for (const Block& block : system.blocks) {
    const auto acts = [&](const auto& action) { return action.block == block.name && !action.table.empty(); };
    moved.push_back(std::any_of(now.loads.begin(), now.loads.end(), acts) ||
                    std::any_of(now.constraints.begin(), now.constraints.end(), acts));
  }
  return moved;
}

void wake_all(SimulationState& s, const Project& now) {
  const bool some_slept = s.sleep.count() > 0;
  s.sleep.begin_stage(moved_by_table(now, s.system));
  if (!some_slept) return;
  update_sleepers(s);
  seek_contacts(s, 0);
  s.energy.awake_changed(s.composition);
}

void hold_bodies_of_stage(SimulationState& s, int stage) {
  const std::vector<std::string> names = blocks_held_in_stage(s.project, stage);
  std::vector<bool> held, fixed;
  for (std::size_t b = 0; b < s.bodies.bodies.size(); ++b) {
    held.push_back(std::find(names.begin(), names.end(), s.system.blocks[b].name) != names.end());
    fixed.push_back(held.back() || s.bodies.bodies[b].built_fixed());
  }
  if (held == s.held) return;
  s.held = held;
  hold_bodies(s, s.sleep.asleep());
  s.detector.set_fixed(fixed);
}

/// Bodies that were built fixed, or that the stage holds: one flag a body.
std::vector<bool> standing_bodies(const SimulationState& s) {
  std::vector<bool> standing = s.held;
  for (std::size_t b = 0; b < standing.size(); ++b) standing[b] = standing[b] || s.bodies.bodies[b].built_fixed();
  return standing;
}

/// What each body may be left with, over the forces on it; 0: only what ConvergenceTolerances leaves to all together. A
/// stage that ends at equilibrium is solved a good deal more exactly than it asks for.
double body_residual(const SimulationState& s, const Stage& stage) {
  const double asked = s.project.solver.tolerance;
  if (asked <= reference_tolerance.value) return 0;
  if (stage.kind == StageKind::dynamic) return asked;
  const ConvergenceTolerances& t = s.tolerances.convergence;
  const double of_rest = stage.until_equilibrium ? std::min(asked, stage.equilibrium_tolerance) : asked;
  return t.static_residual / t.dynamic_residual * of_rest;
}

void compose_effects(SimulationState& s, int stage, bool with_contact) {
  s.open_close.end_stage();
  s.composition = compose(s.project, s.system, stage, s.bodies, s.links, s.tolerances.effects, with_contact);
  s.open_close.begin_stage(s.composition, body_residual(s, s.project.stages[stage]));
  s.expect_impacts();
  s.energy.begin_stage(s.composition);
}

/// Nothing is known yet of the steps of the stage.
void forget_steps(SimulationState& s, double longest_step) {
  std::fill(s.bodies.nodes.prescribed.begin(), s.bodies.nodes.prescribed.end(), Vec3::Zero());
  s.control.begin_stage(longest_step);
  s.pattern_generation = ~0ull;
  s.increment.setZero(s.bodies.unknowns());
  s.first_guess.forget(s.bodies.unknowns());
  s.stage_steps = 0;
  s.pseudo_transient.begin_stage();
}

void set_time_integration(SimulationState& s, StageKind kind) {
  s.context.dynamic_factor = kind == StageKind::dynamic ? 1 : 0;
  s.integration = TimeIntegration::of(s.project.solver);
  if (kind == StageKind::static_ && s.integration.alpha_f > 0) s.integration = TimeIntegration::newmark();
  s.context.integration = s.integration;
  s.context.arms = kind == StageKind::dynamic && s.integration.alpha_f == 0 ? Arms::mean : Arms::end;
}

void give_velocities(SimulationState& s) {
  give_initial_velocities(s.project, s.system, s.bodies);
  s.energy.energy_was_given(s.composition);
  s.velocities_given = true;
}

/// `now`: the project as it holds in the stage of this number.
void set_bodies_and_joints(SimulationState& s, const Project& now, int number) {
  hold_bodies_of_stage(s, number);
  s.detector.set_laws(joint_laws(now));
  s.company.begin_stage(pulls_on_blocks(now, s.system), standing_bodies(s));
}

void set_effects(SimulationState& s, const Project& now, int number, bool with_contact) {
  const Stage& stage = s.project.stages[number];
  compose_effects(s, number, with_contact);
  s.motion.emplace(now, s.system);
  forget_steps(s, stage.time_step);
  set_time_integration(s, stage.kind);
}

}  // namespace

void begin_stage(SimulationState& s) {
  const int number = s.clock.stage();
  const Project now = project_in_stage(s.project, number);
  wake_all(s, now);
  set_bodies_and_joints(s, now, number);
  look_for_company(s, 0);
  set_effects(s, now, number, s.company.any());
  s.free_flight.begin_stage();
  s.acceleration_reset.begin_stage(s.bodies);
  s.followed_contacts = s.dynamic() ? FollowedContacts::new_ones : FollowedContacts::none;
  s.accelerations_wanted = s.dynamic();
  if (s.dynamic() && !s.velocities_given) {
    give_velocities(s);
    look_for_company(s, 0);
    let_touch(s);
  }
}

void set_up_stage(SimulationState& s, int number, bool with_contact, const std::vector<char>& asleep) {
  const Project now = project_in_stage(s.project, number);
  set_bodies_and_joints(s, now, number);
  hold_bodies(s, asleep);
  s.detector.set_asleep(asleep);
  set_effects(s, now, number, with_contact);
}

}  // namespace talus
