#pragma once

#include <span>
#include <vector>

#include "orientation/projection.hpp"

/// Contours of values at the nodes of a square grid over −1 … 1, row by row from the lower left.
namespace talus {

using NetPolygon = std::vector<Vec2>;

/// Where the value is at least `level`, linear between nodes: convex polygons that do not overlap.
std::vector<NetPolygon> region_above(std::span<const double> values, int size, double level);

/// The border of that region as pieces of line, in no order.
std::vector<NetPolygon> contour_lines(std::span<const double> values, int size, double level);

}  // namespace talus
