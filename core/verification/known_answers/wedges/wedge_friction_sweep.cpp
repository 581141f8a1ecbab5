#include <algorithm>

#include "model/number_text.hpp"
#include "verification/known_answers/wedges/wedge_cases.hpp"

namespace talus {

namespace {

/// Between these friction angles [degrees] limit equilibrium lets stay and go the very wedges that did in the physical
/// tests: B1-80-10 stays above the first, B2-320-20 goes below the other.
constexpr double least_explaining = 25.997, most_explaining = 26.880;

/// How many of the 65 rows come out as each column has them, at one friction angle.
struct Matches {
  double friction_angle = 0;  ///< degrees
  int physical = 0, physical_moves = 0, coupled = 0, equilibrium = 0;
  int wrong = 0;  ///< rows off the thresholds with another mode than limit equilibrium
  std::vector<std::string> unlike_physical;
};

std::vector<double> friction_angles(bool thorough) {
  std::vector<double> angles{26.5, plaster_friction_angle};
  for (int i = 0; i <= 10; ++i) angles.push_back(24 + i);
  if (thorough) {
    for (int i = 0; i < 10; ++i) angles.push_back(24.5 + i);
    for (int i = 0; i <= 12; ++i) angles.push_back(25.5 + 0.125 * i);
  }
  std::sort(angles.begin(), angles.end());
  angles.erase(std::unique(angles.begin(), angles.end()), angles.end());
  return angles;
}

Matches matches_at(double friction_angle, const CaseOptions& options, Progress& progress) {
  Matches matches;
  matches.friction_angle = friction_angle;
  for (const WedgeTest& test : wedge_tests()) {
    const std::optional<WedgeMode> mode = run_wedge_test(test, friction_angle, 0, options, progress).mode;
    const WedgeEquilibrium equilibrium = test.equilibrium();
    const bool as_expected = mode == equilibrium.mode(friction_angle);
    matches.equilibrium += as_expected;
    matches.wrong += !as_expected && !at_threshold(equilibrium.factor(friction_angle));
    matches.coupled += mode == test.coupled;
    matches.physical += mode == test.physical;
    matches.physical_moves += (mode == WedgeMode::stable) == (test.physical == WedgeMode::stable);
    if (mode != test.physical)
      matches.unlike_physical.push_back(test.name() + " (" + std::string(mode_text(mode)) + ", not " +
                                        std::string(to_string(test.physical)) + ")");
  }
  return matches;
}

CaseTable table_of(const std::vector<Matches>& sweep) {
  CaseTable table{"Rows, of 65, that come out as each column has them",
                  {"friction angle [°]", "mode of the physical model", "stays or goes as the physical model",
                   "mode of the coupled method", "mode of limit equilibrium at this angle"},
                  {}};
  for (const Matches& matches : sweep)
    table.rows.push_back({decimals(matches.friction_angle, 3), std::to_string(matches.physical),
                          std::to_string(matches.physical_moves), std::to_string(matches.coupled),
                          std::to_string(matches.equilibrium)});
  return table;
}

}  // namespace

CaseOutcome wedge_friction_sweep(const CaseOptions& options, Progress& progress) {
  std::vector<Matches> sweep;
  const std::vector<double> angles = friction_angles(options.thorough);
  for (const double angle : angles) {
    progress.report(sweep.size() / static_cast<double>(angles.size()), "friction angle " + decimals(angle, 3) + "°");
    sweep.push_back(matches_at(angle, options, progress));
  }

  const auto fewer = [](const Matches& a, const Matches& b) { return a.physical < b.physical; };
  const Matches& best = *std::max_element(sweep.begin(), sweep.end(), fewer);
  int wrong = 0;
  double first = 1e300, last = 0;
  for (const Matches& matches : sweep) {
    wrong += matches.wrong;
    if (matches.physical < best.physical) continue;
    first = std::min(first, matches.friction_angle);
    last = std::max(last, matches.friction_angle);
  }

  CaseOutcome outcome;
  outcome.findings = {{.quantity = "rows off the thresholds with another mode than limit equilibrium, all angles",
                       .unit = "",
                       .computed = static_cast<double>(wrong),
                       .absolute = true},
                      {.quantity = "friction angle that explains most physical tests",
                       .unit = "°",
                       .expected = (least_explaining + most_explaining) / 2,
                       .computed = (first + last) / 2,
                       .tolerance = (most_explaining - least_explaining) / 2,
                       .absolute = true,
                       .reported = true},
                      {.quantity = "rows with the mode of the physical model there",
                       .unit = "",
                       .expected = static_cast<double>(wedge_tests().size()),
                       .computed = static_cast<double>(best.physical),
                       .reported = true}};
  outcome.tables.push_back(table_of(sweep));
  std::string remark = "From " + decimals(first, 3) + "° to " + decimals(last, 3) + "° " +
                       std::to_string(best.physical) +
                       " rows have the mode of the physical model, more than at any other angle. Not so";
  for (const std::string& row : best.unlike_physical) remark += (row == best.unlike_physical[0] ? " " : ", ") + row;
  outcome.remarks.push_back(remark);
  return outcome;
}

}  // namespace talus
