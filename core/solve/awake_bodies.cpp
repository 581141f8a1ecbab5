#include "solve/awake_bodies.hpp"

#include "contact/contact_law.hpp"
#include "solve/simulation_state.hpp"

namespace talus {

namespace {

/// Of a contact at the increment that the step has come to, on its first body [N].
Vec3 force_of(const SimulationState& s, int contact) {
  const ContactPoint& point = s.contacts.points[contact];
  const Vec3 normal = normal_force(point, s.links.gap(contact, s.increment)) * point.normal;
  return s.composition.shear ? Vec3(normal + s.composition.shear->force_at(contact, s.increment)) : normal;
}

/// Adds the bodies of contacts that sleep.
void add_sleepers(const auto& contacts, const std::vector<char>& asleep, std::vector<int>& sleepers) {
  for (const auto& contact : contacts)
    for (const int body : contact.bodies)
      if (asleep[body]) sleepers.push_back(body);
}

}  // namespace

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
  s.sleeper_loads.set_resting(s.bodies, s.resting);
  s.pattern_generation = ~0ull;
  s.increment.setZero(s.bodies.unknowns());
  s.first_guess.forget(s.bodies.unknowns());
  s.sleepers_change = false;
}

bool wake_pressed(SimulationState& s, bool converged, std::span<const ContactDetector::MissedContact> missed,
                  int rings) {
  if (s.sleep.count() == 0) return false;
  const std::vector<char>& asleep = s.sleep.asleep();
  const auto force = [&](int contact) { return force_of(s, contact); };
  std::vector<int> wake;
  if (converged)
    wake = s.sleeper_loads.pressed(s.bodies, s.contacts, asleep, force);
  else
    add_sleepers(s.contacts.points, asleep, wake);
  add_sleepers(missed, asleep, wake);
  if (wake.empty()) return false;
  s.sleep.wake(wake, s.resting, rings);
  s.sleepers_change = true;
  return true;
}

}  // namespace talus
