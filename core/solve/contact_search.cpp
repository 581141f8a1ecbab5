#include "solve/contact_search.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "base/stopwatch.hpp"
#include "solve/awake_bodies.hpp"
#include "solve/simulation_state.hpp"

namespace talus {

namespace {

/// Contacts of all who are awake, with those whom they wake.
void seek_and_wake(SimulationState& s, double length) {
  bool changed = s.falls_asleep;
  if (changed) update_sleepers(s);
  seek_contacts(s, length);
  while (s.sleep.wake_touched(s.bodies, s.contacts)) {  // what wakes may touch what sleeps
    update_sleepers(s);
    seek_contacts(s, length);
    changed = true;
  }
  if (changed) account_for_awake_bodies(s);
  if (s.extras() && s.dynamic())
    s.followed_springs.limit(s.project, s.adaptive() ? length : s.clock.next_length(), s.dynamic_penetration(),
                             s.contacts);
}

/// Pairs of degree-of-freedom blocks that contacts couple or may couple soon.
std::vector<std::pair<int, int>> couplings_of_contacts(const SimulationState& s) {
  std::vector<std::pair<int, int>> couplings;
  std::vector<int> dof_blocks, others;
  for (const auto& [i, j] : s.detector.coupled_nodes()) {
    s.bodies.dof_blocks_of(i, dof_blocks);
    s.bodies.dof_blocks_of(j, others);
    for (const int a : dof_blocks)
      for (const int b : others)
        if (a != b) couplings.emplace_back(a, b);
  }
  return couplings;
}

}  // namespace

void seek_contacts(SimulationState& s, double length) {
  s.open_close.release_states();
  double prescribed = 0;
  for (const int b : s.bodies.driven)
    prescribed = std::max(prescribed, s.bodies.nodes.prescribed[s.bodies.bodies[b].first_node].norm());
  const double displacement =
      s.context.dynamic_factor * s.bodies.top_speed() * length + 0.5 * s.project.gravity.norm() * length * length;
  const double reach = s.tolerances.step.reach_factor * (displacement + prescribed);
  s.context.reach = reach + s.smallest_size;
  s.reach = reach + s.tolerances.step.least_reach * s.smallest_size;
  s.detector.detect(s.bodies.nodes.position, s.reach, s.contacts);
  s.links.connect();
}

void detect_contacts(SimulationState& s, double length) {
  const Stopwatch watch(s.detect_seconds);
  seek_and_wake(s, length);
  if (s.pattern_generation == s.detector.coupling_generation()) return;
  s.pattern_generation = s.detector.coupling_generation();
  s.open_close.set_pattern(s.bodies.nodes.movable, couplings_of_contacts(s));
}

}  // namespace talus
