#include <algorithm>
#include <cmath>
#include <map>

#include "model/number_text.hpp"
#include "model/quantity.hpp"
#include "render/paint/numbers.hpp"
#include "report/sections.hpp"
#include "report/words.hpp"

namespace talus::report {

namespace {

std::string expectations_text(long missed, long expected) {
  if (expected == 0) return "";
  if (expected == 1) return missed > 0 ? " The expectation is missed." : " The expectation is met.";
  return missed > 0 ? " " + std::to_string(missed) + " of " + std::to_string(expected) + " expectations are missed."
                    : " All " + std::to_string(expected) + " expectations are met.";
}

Paragraph verdict(const RunRecord& run) {
  using Kind = Paragraph::Kind;
  const double time = run.last.time;
  if (!run.report)
    return {"Not finished: the run goes on or was killed. This is what it wrote up to " + given(time) + "\u00a0s.",
            Kind::bad};
  const long missed = missed_expectations(*run.report);
  const auto expected = static_cast<long>(run.report->expect.size());
  switch (run.report->status) {
    case RunStatus::completed:
      return {"Completed: every step converged, all stages were run to their end at " + given(time) +
                  "\u00a0s of model time." + expectations_text(missed, expected),
              missed > 0 ? Kind::bad : Kind::good};
    case RunStatus::stopped:
      return {"Stopped by the user at " + given(time) + "\u00a0s of model time; every step up to there converged.",
              Kind::bad};
    case RunStatus::not_converged:
      return {"Not completed: " + run.report->reason, Kind::bad};
    case RunStatus::interpenetrating:
      break;
  }
  return {"Ended because blocks came to lie in each other: " + run.report->reason, Kind::bad};
}

/// "812 m, by block S3: 640 m horizontally towards 078°, 430 m down".
std::string farthest_text(const BlockTravel& travel, const BlockSystem& system) {
  const Vec3& way = travel.displacement;
  if (way.norm() == 0) return "none: no block has moved";
  const Prefixed unit = prefixed("m", way.norm());
  const auto length = [&](double value) { return format_number(unit.factor * value, 3) + "\u00a0" + unit.unit; };
  const std::string text =
      length(way.norm()) + ", by block " + system.blocks[static_cast<std::size_t>(travel.block)].name;
  const double level = std::hypot(way.x(), way.y());
  if (level == 0) return text + ", straight " + (way.z() > 0 ? "up" : "down");
  const std::string trend = attitude_text(Vec3(way.x(), way.y(), 0));
  return text + ": " + length(level) + " horizontally towards " + trend.substr(0, trend.find('/')) + ", " +
         length(std::abs(way.z())) + (way.z() > 0 ? " up" : " down");
}

/// "5 sliding on one plane, 2 toppling; 3 of these have come to rest".
std::string modes_text(const RunRecord& run) {
  std::map<MotionMode, long> counts;
  long came_to_rest = 0;
  for (const BlockTravel& travel : run.travels) {
    const MotionClass& motion = run.last.motions[static_cast<std::size_t>(travel.block)];
    ++counts[motion.mode];
    came_to_rest += motion.came_to_rest;
  }
  std::string text;
  for (const auto& [mode, count] : counts)
    text += (text.empty() ? "" : ", ") + count_text(count) + " " + std::string(to_string(mode));
  if (came_to_rest > 0)
    text += "; " + count_text(came_to_rest) +
            (came_to_rest == 1 ? " of these has come to rest" : " of these have come to rest");
  return text;
}

std::string fastest_text(const RunRecord& run) {
  const auto fastest =
      std::ranges::max_element(run.travels, {}, [](const BlockTravel& travel) { return travel.velocity.norm(); });
  if (fastest->velocity.norm() == 0) return "0\u00a0m/s: all blocks are at rest";
  return quantity(fastest->velocity.norm(), "m/s") + ", block " +
         run.system().blocks[static_cast<std::size_t>(fastest->block)].name;
}

std::string events_text(const std::vector<Event>& events) {
  if (events.empty()) return "none";
  const std::string first = given(events.front().time) + "\u00a0s";
  return events.size() == 1 ? "1 event, at " + first
                            : count_text(static_cast<long>(events.size())) + " events, the first at " + first;
}

Facts main_facts(const RunRecord& run) {
  Facts facts;
  if (!run.travels.empty()) {
    facts.rows.push_back({"Largest displacement", farthest_text(run.travels.front(), run.system())});
    facts.rows.push_back({"Fastest block at the end", fastest_text(run)});
    if (!run.last.motions.empty()) facts.rows.push_back({"Movable blocks by motion", modes_text(run)});
  }
  if (run.report) {
    facts.rows.push_back({"Events", events_text(run.report->events)});
    facts.rows.push_back({"Deepest penetration", quantity(run.report->max_penetration, "m", 2) + ", " +
                                                     percent(run.report->max_relative_penetration) +
                                                     " of the local mesh size"});
  }
  const double moved = energy_moved(run.steps);
  if (moved > 0) {
    const EnergyLedger& energy = run.steps.back().energy;
    facts.rows.push_back(
        {"Energy unaccounted for", percent(std::abs(energy.remainder) / moved) + " of the energy that moved"});
    facts.rows.push_back(
        {"Energy lost in time integration", percent(energy.integration_loss / moved) + " of the energy that moved"});
  }
  return facts;
}

Table expectations(const std::vector<ExpectationOutcome>& outcomes) {
  Table table{"Expected against computed",
              {"Quantity", "Time (s)", "Expected", "Computed", "Error", "Tolerance", "Passed", "Source"},
              "lrrrrrll",
              {}};
  for (const ExpectationOutcome& outcome : outcomes) {
    const Expectation& expected = outcome.expectation;
    const bool relative = expected.value != 0;
    const auto error = [&](double value) { return relative ? percent(value) : format_number(value, 2); };
    const auto wanted = parse_quantity(expected.quantity);
    const auto value_text = [&](double value) {
      return wanted ? quantity(value, std::string(unit_of(wanted->field)), 4) : format_number(value, 4);
    };
    table.rows.push_back({expected.quantity, given(expected.time), value_text(expected.value),
                          outcome.reached ? value_text(outcome.computed) : "not reached",
                          outcome.reached ? error(outcome.error) : "–", error(expected.tolerance),
                          outcome.passed ? "yes" : "no", expected.source});
  }
  return table;
}

}  // namespace

Section answer(const RunRecord& run) {
  Section section{"What came out", {verdict(run), main_facts(run)}};
  if (!run.report) return section;
  if (!run.report->expect.empty())
    section.parts.emplace_back(expectations(run.report->expect));
  else
    section.parts.emplace_back(Paragraph{
        "The project states no expected values, so nothing was held against known answers.", Paragraph::Kind::note});
  return section;
}

}  // namespace talus::report
