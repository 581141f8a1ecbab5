#include <algorithm>

#include "model/stage_changes.hpp"
#include "solve/initial_motion.hpp"
#include "solve/joint_laws.hpp"
#include "solve/simulation_state.hpp"

/// What changes between steps: stages begin, blocks are held, fall asleep and wake.
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

}  // namespace

void Simulation::hold_blocks(int stage) {
  State& s = *state_;
  const std::vector<std::string> names = blocks_held_in_stage(s.project, stage);
  std::vector<bool> held, fixed;
  for (std::size_t b = 0; b < s.bodies.bodies.size(); ++b) {
    held.push_back(std::find(names.begin(), names.end(), s.system.blocks[b].name) != names.end());
    fixed.push_back(held.back() || s.bodies.bodies[b].built_fixed());
  }
  if (held == s.held) return;
  s.held = held;
  keep_still();
  s.detector.set_fixed(fixed);
}

void Simulation::keep_still() {
  State& s = *state_;
  if (!s.composition.effects.empty()) s.bodies.stress = present_stress();
  std::vector<bool> still = s.held;
  for (std::size_t b = 0; b < still.size(); ++b) still[b] = still[b] || s.sleep.asleep()[b];
  s.bodies.hold(still);
}

void Simulation::let_sleep_and_wake() {
  State& s = *state_;
  keep_still();
  s.detector.set_asleep(s.sleep.asleep());
  s.resting = s.detector.resting();
  s.pattern_generation = ~0ull;
  s.increment.setZero(s.bodies.unknowns());
  s.first_guess.forget(s.bodies.unknowns());
  s.falls_asleep = false;
}

void Simulation::account_for_the_awake() {
  State& s = *state_;
  for (NormalContact* normal : s.composition.normal) normal->accept(s.increment);
  if (s.composition.shear) s.composition.shear->resume(s.increment);
  s.energy.awake_changed(s.composition);
}

void Simulation::begin_stage() {
  State& s = *state_;
  const int number = s.clock.stage();
  const Stage& stage = s.project.stages[number];
  const Project now = project_in_stage(s.project, number);
  const bool some_slept = s.sleep.count() > 0;
  s.sleep.begin_stage(moved_by_table(now, s.system));
  if (some_slept) {
    let_sleep_and_wake();
    seek_contacts(0);
    account_for_the_awake();
  }
  hold_blocks(number);
  s.detector.set_laws(joint_laws(now));
  s.open_close.end_stage();
  s.composition = compose(s.project, s.system, number, s.bodies, s.links);
  s.open_close.begin_stage(s.composition);
  if (s.composition.rebounds && !s.impacts) s.impacts.emplace(s.bodies);
  s.energy.begin_stage(s.composition);
  s.motion.emplace(now, s.system);
  std::fill(s.bodies.nodes.prescribed.begin(), s.bodies.nodes.prescribed.end(), Vec3::Zero());
  s.control.begin_stage(stage.time_step);
  s.pattern_generation = ~0ull;
  s.increment.setZero(s.bodies.unknowns());
  s.first_guess.forget(s.bodies.unknowns());
  s.stage_steps = 0;
  s.context.dynamic_factor = stage.kind == StageKind::dynamic ? 1 : 0;
  s.integration = TimeIntegration::of(s.project.solver);
  if (stage.kind == StageKind::static_ && s.integration.alpha_f > 0) s.integration = TimeIntegration::newmark();
  s.context.integration = s.integration;
  s.fading.begin_stage();
  s.bodies.mean_arms = stage.kind == StageKind::dynamic && s.context.integration.alpha_f == 0;
  s.accelerations_wanted = stage.kind == StageKind::dynamic;
  if (stage.kind == StageKind::dynamic && !s.velocities_given) {
    give_initial_velocities(s.project, s.system, s.bodies);
    s.energy.energy_was_given(s.composition);
    s.velocities_given = true;
  }
}

}  // namespace talus
