#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/paint/image.hpp"
#include "render/paint/theme.hpp"

namespace talus {

/// One run: what it cost and how far off it was.
struct CostPoint {
  int number = 0;                  ///< on the chart and in the list beside it
  std::string label;               ///< in the list
  double seconds = 0;              ///< above 0
  double error = 0;                ///< relative
  double uncertainty = 0;          ///< of the error, drawn as a bar; 0: none
  std::optional<double> spread{};  ///< of one run about the mean that the error is of: in the list
  int group = 0;                   ///< into CostPlot::groups, by colour
  bool on_front = false, recommended = false;
};
/// Below this a relative error is rounding, and drawn at the foot of the chart: it would stretch the axis beyond
/// reading.
inline constexpr double smallest_error = 1e-10;

/// Error against seconds, both logarithmic: each run a numbered point, the front of the best drawn through, and beside
/// it the list of runs.
struct CostPlot {
  std::string title, error_title;
  std::vector<std::string> groups;  ///< at most 6
  std::vector<CostPoint> points;
  std::vector<std::string> notes;  ///< below the list
  std::optional<double> target;    ///< error that is asked for
  Theme theme = Theme::light;
};

/// Throws std::invalid_argument without points, or with a group there is not, InputError for sizes outside 320…8192.
Image draw_cost_chart(const CostPlot& plot, int width = 1600, int height = 1000);

}  // namespace talus
