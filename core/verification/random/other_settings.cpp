#include "verification/random/other_settings.hpp"

#include <vector>

#include "model/number_text.hpp"

namespace talus {

namespace {

/// Half of the time as it was.
Switch drawn_switch(SceneNumbers& numbers, Switch before, bool may_be_off) {
  const bool changes = numbers.chance(0.5), off = numbers.chance(0.5);
  if (!changes) return before;
  return off && may_be_off ? Switch::off : Switch::on;
}

class Changes {
 public:
  void note(const std::string& name, const std::string& word) {
    text_ += (text_.empty() ? "" : ", ") + name + ' ' + word;
  }
  void compare(const std::string& name, double before, double after) {
    if (before != after) note(name, significant(after));
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

}  // namespace

SolverSettings other_settings(SceneNumbers& numbers, SolverSettings settings) {
  const double penetration = numbers.logarithmic(2e-5, 5e-4);
  if (numbers.chance(0.3)) settings.penetration_tolerance = penetration;
  const double limit = numbers.logarithmic(0.5, 4);
  if (numbers.chance(0.5)) settings.open_close_limit = static_cast<int>(limit * settings.open_close_limit);
  // What is kept awake so that it holds by itself stays so.
  const bool wakes = numbers.chance(0.3);
  if (wakes) settings.sleep_tolerance = 0;
  AdaptiveSteps& adaptive = settings.adaptive;
  adaptive.displacement_limit *= numbers.logarithmic(0.2, 1);
  adaptive.error_limit *= numbers.logarithmic(0.2, 1);
  adaptive.iterations = numbers.whole(4, 16);
  EffectSwitches& effects = settings.effects;
  effects.contact = drawn_switch(numbers, effects.contact, false);
  effects.missed_contacts = drawn_switch(numbers, effects.missed_contacts, false);
  effects.updated_normals = drawn_switch(numbers, effects.updated_normals, false);
  effects.penalty_scaling = drawn_switch(numbers, effects.penalty_scaling, false);
  effects.followed_springs = drawn_switch(numbers, effects.followed_springs, false);
  effects.acceleration_reset = drawn_switch(numbers, effects.acceleration_reset, false);
  effects.elimination = drawn_switch(numbers, effects.elimination, true);
  return settings;
}

std::string changed_settings(const SolverSettings& before, const SolverSettings& after) {
  Changes changes;
  if (before.penetration_tolerance != after.penetration_tolerance)
    changes.note("penetration_tolerance", significant(after.penetration_tolerance.value_or(0)));
  changes.compare("open_close_limit", before.open_close_limit, after.open_close_limit);
  if (before.sleep_tolerance != after.sleep_tolerance)
    changes.note("sleep_tolerance", significant(after.sleep_tolerance.value_or(0)));
  if (after.time_step_control == TimeStepControl::adaptive) {
    changes.compare("displacement_limit", before.adaptive.displacement_limit, after.adaptive.displacement_limit);
    changes.compare("error_limit", before.adaptive.error_limit, after.adaptive.error_limit);
    changes.compare("iterations", before.adaptive.iterations, after.adaptive.iterations);
  }
  std::vector<Switch> switches;
  for_each_switch(before.effects, [&](const char*, Switch choice) { switches.push_back(choice); });
  auto old = switches.begin();
  for_each_switch(after.effects, [&](const char* name, Switch choice) {
    if (choice != *old++) changes.note(name, std::string(to_string(choice)));
  });
  return changes.text();
}

}  // namespace talus
