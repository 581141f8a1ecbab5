#pragma once

#include <vector>

#include "render/paint/painter.hpp"

namespace talus {

/// Where discs of one radius stand that mark points, so that no two overlap: on its point where there is room, else as
/// near to it as room is, within the rectangle. In the order of the points, which come first come best.
std::vector<PixelPoint> place_tags(const std::vector<PixelPoint>& points, double radius, const PixelRect& within);

}  // namespace talus
