#include "solve/awake_bodies.hpp"

#include "solve/simulation_state.hpp"

namespace talus {

void hold_bodies(SimulationState& s, const std::vector<char>& asleep) {
  if (!s.composition.effects.empty()) s.bodies.stress = s.stress.all();
  std::vector<bool> held = s.held;
  for (std::size_t b = 0; b < held.size(); ++b) held[b] = held[b] || asleep[b];
  s.bodies.hold(held);
}

void update_sleepers(SimulationState& s) {
  hold_bodies(s, s.sleep.asleep());
  s.detector.set_asleep(s.sleep.asleep());
  s.resting = s.detector.resting();
  s.pattern_generation = ~0ull;
  s.increment.setZero(s.bodies.unknowns());
  s.first_guess.forget(s.bodies.unknowns());
  s.falls_asleep = false;
}

}  // namespace talus
