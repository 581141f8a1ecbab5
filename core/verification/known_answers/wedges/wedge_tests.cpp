#include <algorithm>
#include <cmath>

#include "base/units.hpp"
#include "model/number_text.hpp"
#include "verification/known_answers/wedges/wedge_cases.hpp"

namespace talus {

namespace {

/// "(0.45, 0.63, -0.63)", or "–" for a zero vector.
std::string direction_text(const Vec3& direction) {
  if (direction.isZero()) return "–";
  return "(" + decimals(direction.x(), 2) + ", " + decimals(direction.y(), 2) + ", " + decimals(direction.z(), 2) + ")";
}

constexpr double direction_tolerance = 2;  // degrees
constexpr double stray_tolerance = 1e-6;   // of the normal force
constexpr int usual_refinements = 1;

struct TestOutcome {
  const WedgeTest& test;
  WedgeEquilibrium equilibrium;
  WedgeMotion motion;

  double factor() const { return equilibrium.factor(plaster_friction_angle); }
  bool threshold() const { return at_threshold(factor()); }
  WedgeMode expected() const { return equilibrium.mode(plaster_friction_angle); }
  /// Degrees between computed direction and limit equilibrium's; zero where the wedge stays.
  double deviation() const {
    if (motion.direction.isZero()) return 0;
    return degrees(std::acos(std::min(1.0, motion.direction.dot(equilibrium.direction))));
  }
};

std::vector<TestOutcome> run_all(int refinements, const CaseOptions& options, Progress& progress) {
  std::vector<TestOutcome> outcomes;
  for (const WedgeTest& test : wedge_tests()) {
    progress.report(outcomes.size() / static_cast<double>(wedge_tests().size()), "wedge test " + test.name());
    outcomes.push_back(
        {test, test.equilibrium(), run_wedge_test(test, plaster_friction_angle, refinements, options, progress)});
  }
  return outcomes;
}

CaseTable table_of(const std::vector<TestOutcome>& outcomes) {
  CaseTable table{"Wedge tests at a friction angle of " + decimals(plaster_friction_angle, 1) + "°",
                  {"test", "β", "α", "computed", "direction", "off limit equilibrium [°]", "coupled method",
                   "its direction", "physical model", "limit equilibrium", "factor of safety", "threshold"},
                  {}};
  for (const TestOutcome& outcome : outcomes) {
    const WedgeTest& test = outcome.test;
    const auto& coupled = test.coupled_direction;
    table.rows.push_back({test.name(), number_text(test.beta), number_text(test.alpha),
                          std::string(mode_text(outcome.motion.mode)), direction_text(outcome.motion.direction),
                          outcome.motion.direction.isZero() ? "–" : decimals(outcome.deviation(), 3),
                          std::string(to_string(test.coupled)), direction_text({coupled[0], coupled[1], coupled[2]}),
                          std::string(to_string(test.physical)), std::string(to_string(outcome.expected())),
                          decimals(outcome.factor(), 3), outcome.threshold() ? "yes" : ""});
  }
  return table;
}

/// What the rows away from the thresholds are held to.
void hold(const std::vector<TestOutcome>& outcomes, int refinements, CaseOutcome& outcome) {
  int wrong = 0;
  double deviation = 0, stray = 0;
  for (const TestOutcome& row : outcomes) {
    stray = std::max(stray, row.motion.stray);
    if (row.threshold()) continue;
    wrong += row.motion.mode != row.expected();
    deviation = std::max(deviation, row.deviation());
  }
  const std::string mesh = " (tetrahedra: " + std::to_string(1 << (3 * refinements)) + ")";
  outcome.findings.push_back({.quantity = "rows off the thresholds with another mode than limit equilibrium" + mesh,
                              .unit = "",
                              .computed = static_cast<double>(wrong),
                              .absolute = true});
  outcome.findings.push_back({.quantity = "largest deviation of their directions" + mesh,
                              .unit = "°",
                              .computed = deviation,
                              .tolerance = direction_tolerance,
                              .absolute = true});
  outcome.findings.push_back({.quantity = "largest share of normal force on neither plane" + mesh,
                              .unit = "",
                              .computed = stray,
                              .tolerance = stray_tolerance,
                              .absolute = true});
}

/// Agreement that is shown and not held to: with the paper's two columns, and at the thresholds.
void report(const std::vector<TestOutcome>& outcomes, CaseOutcome& outcome) {
  const auto add = [&](const std::string& quantity, bool thresholds_only, auto agrees) {
    int rows = 0, agreed = 0;
    for (const TestOutcome& row : outcomes) {
      if (thresholds_only && !row.threshold()) continue;
      ++rows;
      agreed += agrees(row);
    }
    outcome.findings.push_back({.quantity = quantity,
                                .unit = "",
                                .expected = static_cast<double>(rows),
                                .computed = static_cast<double>(agreed),
                                .reported = true});
  };
  const auto physical = [](const TestOutcome& row) { return row.motion.mode == row.test.physical; };
  const auto coupled = [](const TestOutcome& row) { return row.motion.mode == row.test.coupled; };
  const auto equilibrium = [](const TestOutcome& row) { return row.motion.mode == row.expected(); };
  add("rows with the mode of the physical model", false, physical);
  add("rows with the mode of the coupled method", false, coupled);
  add("threshold rows with the mode of the physical model", true, physical);
  add("threshold rows with the mode of the coupled method", true, coupled);
  add("threshold rows with the mode of limit equilibrium", true, equilibrium);
}

/// Each row where the columns and the computed mode are not of one mind.
void remark(const std::vector<TestOutcome>& outcomes, CaseOutcome& outcome) {
  for (const TestOutcome& row : outcomes) {
    const std::optional<WedgeMode> mode = row.motion.mode;
    if (mode == row.test.physical && mode == row.test.coupled && mode == row.expected()) continue;
    outcome.remarks.push_back(row.test.name() + ": computed " + std::string(mode_text(mode)) + ", physical model " +
                              std::string(to_string(row.test.physical)) + ", coupled method " +
                              std::string(to_string(row.test.coupled)) + ", limit equilibrium " +
                              std::string(to_string(row.expected())) + " with a factor of " +
                              decimals(row.factor(), 3));
  }
}

}  // namespace

CaseOutcome wedge_tests_case(const CaseOptions& options, Progress& progress) {
  CaseOutcome outcome;
  const std::vector<TestOutcome> rows = run_all(usual_refinements, options, progress);
  hold(rows, usual_refinements, outcome);
  report(rows, outcome);
  remark(rows, outcome);
  outcome.tables.push_back(table_of(rows));
  if (options.thorough)
    for (const int refinements : {0, 2}) hold(run_all(refinements, options, progress), refinements, outcome);
  return outcome;
}

}  // namespace talus
