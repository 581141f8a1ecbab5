#include "render/charts/tag_layout.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace talus {

namespace {

bool free_of(const PixelPoint& at, const std::vector<PixelPoint>& others, double apart) {
  return std::all_of(others.begin(), others.end(),
                     [&](const PixelPoint& other) { return std::hypot(at.x - other.x, at.y - other.y) >= apart; });
}

bool inside(const PixelPoint& at, const PixelRect& rect, double radius) {
  return at.x - radius >= rect.left && at.x + radius <= rect.right && at.y - radius >= rect.bottom &&
         at.y + radius <= rect.top;
}

}  // namespace

std::vector<PixelPoint> place_tags(const std::vector<PixelPoint>& points, double radius, const PixelRect& within) {
  constexpr int directions = 16, rings = 60;
  std::vector<PixelPoint> placed;
  for (const PixelPoint& point : points) {
    PixelPoint best = point;
    bool found = free_of(point, placed, 2 * radius);
    for (int ring = 2; ring < rings && !found; ++ring)
      for (int k = 0; k < directions && !found; ++k) {
        const double angle = std::numbers::pi * (0.25 + 2.0 * k / directions), reach = ring * radius;
        best = {point.x + reach * std::cos(angle), point.y + reach * std::sin(angle)};
        found = inside(best, within, radius) && free_of(best, placed, 2.1 * radius);
      }
    placed.push_back(found ? best : point);
  }
  return placed;
}

}  // namespace talus
