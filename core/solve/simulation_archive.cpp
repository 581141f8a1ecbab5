#include "base/state_archive.hpp"
#include "solve/simulation.hpp"
#include "solve/simulation_state.hpp"
#include "solve/stage_start.hpp"

/// All that the next steps hang on, to the last bit. What follows from the project, the stage and the positions is made
/// anew: features, boxes, patterns, analyses and factors.
namespace talus {

namespace {

/// Bodies that are held as they sleep: those that have just fallen asleep are not yet.
std::vector<char> held_sleepers(const SimulationState& s) {
  std::vector<char> asleep;
  for (std::size_t b = 0; b < s.bodies.bodies.size(); ++b)
    asleep.push_back(s.bodies.bodies[b].fixed && !s.bodies.bodies[b].built_fixed() && !s.held[b]);
  return asleep;
}

/// What says which stage is to be set up, and how.
void archive_stage(SimulationState& s, int stage, StateArchive& state) {
  bool with_contact = !s.composition.normal.empty();
  std::vector<char> asleep = held_sleepers(s);
  state(s.clock, stage, with_contact, asleep);
  if (state.reads()) set_up_stage(s, stage, with_contact, asleep);
  state(s.sleep, s.sleeper_loads, s.company, s.control, s.pseudo_transient, s.followed_contacts, s.velocities_given,
        s.stage_steps);
}

void archive_bodies(SimulationState& s, StateArchive& state) {
  state(s.bodies, s.contacts);
  s.detector.archive(state);
  for (const auto& effect : s.composition.effects) effect->archive(state);
}

void archive_step(SimulationState& s, StateArchive& state) {
  StepContext& c = s.context;
  state(c.time, c.length, c.dynamic_factor, c.integration, c.arms, c.reach);
  state(s.trial_length, s.reach, s.increment, s.goes_through, s.accelerations_wanted, s.sleepers_change, s.step);
  state(s.first_guess, s.acceleration_reset, s.reserve, s.free_flight);
}

void archive_readings(SimulationState& s, StateArchive& state) {
  state(s.energy, s.stress, s.detect_seconds, s.extra_work, s.block_steps_asleep, s.correction_limits);
  if (s.impacts) state(*s.impacts);
}

}  // namespace

void Simulation::archive(StateArchive& state) {
  SimulationState& s = *state_;
  archive_stage(s, stage(), state);
  archive_bodies(s, state);
  archive_step(s, state);
  state(s.pattern_generation);
  s.open_close.archive(state, s.pattern_generation == s.detector.coupling_generation());
  archive_readings(s, state);
  if (!state.reads()) return;
  s.links.connect(s.context.arms);
  s.resting = s.detector.resting();
}

}  // namespace talus
