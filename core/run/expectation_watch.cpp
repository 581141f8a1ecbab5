#include "run/expectation_watch.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "bodies/block_motion.hpp"
#include "solve/simulation.hpp"

namespace talus {

namespace {

template <class Named>
int index_of(const std::vector<Named>& list, const std::string& name) {
  const auto found = std::find_if(list.begin(), list.end(), [&](const Named& item) { return item.name == name; });
  return found == list.end() ? -1 : static_cast<int>(found - list.begin());
}

}  // namespace

ExpectationWatch::ExpectationWatch(const Project& project, const BlockSystem& system) {
  for (const Expectation& expectation : project.expect) {
    const auto quantity = parse_quantity(expectation.quantity);
    Watched watched;
    watched.expectation = expectation;
    if (quantity) {
      watched.quantity = *quantity;
      watched.monitor = index_of(project.monitors, quantity->of);
      watched.block = index_of(system.blocks, quantity->of);
    }
    if (watched.monitor < 0 && watched.block < 0)
      throw InputError("expectation '" + expectation.quantity + "'", "is no quantity of this run",
                       "write MONITOR or BLOCK, then .displacement or .velocity, then .x, .y, .z or .magnitude, or "
                       "MONITOR.stress.zz");
    watched_.push_back(watched);
  }
}

void ExpectationWatch::follow(Watched& watched, const FieldValue& value, double time) {
  const auto at = [&](double wanted) -> FieldValue {
    const double share = time > last_time_ ? (wanted - last_time_) / (time - last_time_) : 1;
    return watched.last + share * (value - watched.last);
  };
  if (watched.last.size() == 0) watched.last = value;
  const double slack = 1e-12 * std::max(1.0, time);
  if (!watched.start && watched.expectation.since && *watched.expectation.since <= time + slack)
    watched.start = at(std::min(*watched.expectation.since, time));
  if (!watched.end && watched.expectation.time <= time + slack)
    watched.end = at(std::min(watched.expectation.time, time));
  watched.last = value;
}

void ExpectationWatch::look(const Simulation& simulation, const HistoryRow& row) {
  const double time = simulation.time();
  for (Watched& watched : watched_) {
    if (watched.monitor >= 0) {
      follow(watched, field_value(row.monitors[watched.monitor], watched.quantity.field), time);
      continue;
    }
    const BlockMotion motion = block_motion(simulation.bodies(), watched.block);
    follow(watched, field_value({motion.displacement, motion.velocity}, watched.quantity.field), time);
  }
  last_time_ = time;
}

std::vector<ExpectationOutcome> ExpectationWatch::outcomes() const {
  std::vector<ExpectationOutcome> outcomes;
  for (const Watched& watched : watched_) {
    const Expectation& e = watched.expectation;
    ExpectationOutcome outcome{e, 0, 0, watched.end.has_value(), false};
    if (outcome.reached) {
      FieldValue change = *watched.end;
      if (watched.start) change -= *watched.start;
      outcome.computed = component_of(change, watched.quantity.component);
      outcome.error = std::abs(outcome.computed - e.value) / (e.value == 0 ? 1 : std::abs(e.value));
      outcome.passed = outcome.error <= e.tolerance;
    }
    outcomes.push_back(outcome);
  }
  return outcomes;
}

}  // namespace talus
