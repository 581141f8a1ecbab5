#include "text/report_text.hpp"

#include <algorithm>

#include "model/number_text.hpp"
#include "model/tolerance_text.hpp"
#include "text/effect_text.hpp"
#include "text/table.hpp"
#include "text/terminal.hpp"

namespace talus::cli {

namespace {

std::string vector_text(const Vec3& vector) {
  return number(vector.x(), 4) + ", " + number(vector.y(), 4) + ", " + number(vector.z(), 4);
}

std::string cost_text(const RunReport& report) {
  const double steps = std::max(1, report.steps);
  return number(report.time) + " s of model time in " + std::to_string(report.steps) + " steps, " +
         number(static_cast<double>(report.iterations) / steps, 3) + " iterations a step, " +
         std::to_string(report.cuts) + (report.cuts == 1 ? " step cut" : " steps cut") + ", tolerance " +
         tolerance_text(report.tolerance) + "; wall time " + duration_text(report.wall_seconds) + " (" +
         number(1e3 * report.wall_seconds / steps, 3) + " ms a step)\n";
}

std::string blocks_text(const RunReport& report) {
  Table table({"Block", "Body", "Displacement [m]", "Rotation [°]", "Velocity [m/s]", "Volume change", "Motion",
               "Trend/plunge"},
              "lllrlrll");
  for (const BlockOutcome& block : report.blocks) {
    if (block.body == BodyKind::fixed) continue;
    table.add({block.name, std::string(to_string(block.body)), vector_text(block.displacement),
               number(block.rotation_degrees, 4), vector_text(block.velocity), number(block.relative_volume_change, 2),
               motion_text(block.motion, report.names), attitude_text(block.motion.direction)});
  }
  return table.text();
}

}  // namespace

std::string report_text(const RunReport& report) {
  std::string text = std::string(to_string(report.status));
  if (!report.reason.empty()) text += ": " + report.reason;
  text += "\n" + cost_text(report) + "Largest penetration " + number(report.max_penetration, 3) + " m, " +
          number(report.max_relative_penetration, 3) + " of the mesh size\n" + blocks_text(report) + '\n' +
          profile_text(report) + '\n';
  for (const Event& event : report.events) text += number(event.time) + " s  " + event.what + "\n";
  if (!report.expect.empty()) text += expectations_text(report.expect);
  return text + troubles_text(report.troubles);
}

std::string troubles_text(const std::vector<ConvergenceTrouble>& troubles) {
  if (troubles.empty()) return "";
  Table table({"Contact", "Joint", "Place", "Time [s]", "Steps cut", "Iterations", "What to change"}, "lllrrrl");
  for (const ConvergenceTrouble& trouble : troubles)
    table.add({trouble.blocks[0].empty() ? "no place" : contact_text(trouble), trouble.joint, position_text(trouble),
               number(trouble.time, 4), std::to_string(trouble.cuts), count_text(trouble.iterations), trouble.advice});
  const bool ended = troubles.front().ended_run;
  return std::string("\nWhere it was hard") + (ended ? "; the run ended at the first place\n" : "\n") + table.text();
}

std::string expectations_text(const std::vector<ExpectationOutcome>& outcomes) {
  Table table({"Quantity", "Time [s]", "Expected", "Computed", "Error", "Tolerance", "Passed", "Source"}, "lrrrrrll");
  for (const ExpectationOutcome& outcome : outcomes) {
    const Expectation& expected = outcome.expectation;
    table.add({expected.quantity, number(expected.time), number(expected.value, 8),
               outcome.reached ? number(outcome.computed, 8) : "not reached",
               outcome.reached ? number(outcome.error, 2) : "", number(expected.tolerance, 2),
               outcome.passed ? "yes" : "no", expected.source});
  }
  return table.text();
}

std::string events_text(const std::vector<EventComparison>& comparisons) {
  Table table({"Event", "Published [s]", "Computed [s]", "Difference [s]", "At published time", "Counts when"},
              "lrrrrl");
  for (const EventComparison& comparison : comparisons) {
    const ReferenceEvent& event = comparison.event;
    table.add({event.what, number(event.time), comparison.computed ? number(*comparison.computed, 4) : "did not happen",
               comparison.computed ? number(*comparison.computed - event.time, 3) : "",
               comparison.value_then ? number(*comparison.value_then, 4) : "", event.criterion});
  }
  return table.text();
}

}  // namespace talus::cli
