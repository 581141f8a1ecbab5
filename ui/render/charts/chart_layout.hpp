#pragma once

#include <span>
#include <vector>

#include "render/paint/painter.hpp"

namespace talus {

/// Of the lines of axes and grids, in text heights.
inline constexpr double axis_width = 0.06, grid_width = 0.05;

/// A label beside its vertical line. Pixels.
struct MarkLabel {
  double line = 0;   ///< x of the line
  double width = 0;  ///< of the text
  double left = 0;   ///< where the text begins; found by `arrange`
  int row = 0;       ///< 0 lies next to the curves; found by `arrange`
};

/// Puts every label right of its line, or left of it where it would pass `right_end`, and into rows so that no two
/// labels meet and no line crosses a label on its way down. (Where a label on the left and an earlier one on the right
/// reach over each other's lines, one crossing cannot be avoided.) Labels must be ordered by `line`.
/// Returns the number of rows.
int arrange(std::span<MarkLabel> labels, double gap, double right_end);

/// Moves heights apart until neighbours are `spacing` from each other, within [low, high] as far as they fit there,
/// each as near to where it was as that allows. Any order; the order of heights is kept.
std::vector<double> spread(const std::vector<double>& heights, double spacing, double low, double high);

/// The polyline without the points that lie within `tolerance` of it (Douglas and Peucker).
std::vector<PixelPoint> simplified(const std::vector<PixelPoint>& points, double tolerance);

}  // namespace talus
