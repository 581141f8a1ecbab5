#pragma once

#include <string_view>
#include <vector>

#include "verification/known_answers/support/known_case.hpp"

/// A column on an incline: the chart of Ashby (1971) with the corrections of Sagaseta (1986), who asked what dynamics
/// says of a block that begins to turn about its toe.
namespace talus {

enum class ColumnMode { stable, slides, topples, slides_and_topples };

constexpr std::string_view to_string(ColumnMode mode) {
  switch (mode) {
    case ColumnMode::stable:
      return "stable";
    case ColumnMode::slides:
      return "slides";
    case ColumnMode::topples:
      return "topples";
    case ColumnMode::slides_and_topples:
      break;
  }
  return "slides and topples";
}

/// A point of the chart; angles in degrees.
struct ColumnPoint {
  double slenderness = 1;  ///< κ = width along the slope over height = tan δ
  double dip = 0, friction_angle = 0;
};

/// Friction angle [degrees] from which a column that topples (κ < tan α) turns about its toe without slipping:
/// tan φ = [(4κ² + 1) tan α + 3κ] / [κ² + 4 + 3κ tan α].
double friction_angle_of_pure_toppling(double slenderness, double dip);

ColumnMode expected_mode(const ColumnPoint& point);

/// Points 1° to either side of each line of the chart.
std::vector<ColumnPoint> points_beside_the_lines(const std::vector<double>& slendernesses);

std::vector<KnownCase> slide_or_topple_cases();

}  // namespace talus
