#include "render/paint/panel_grid.hpp"

#include <algorithm>

namespace talus {

PanelGrid panel_grid(int count, double width, double height) {
  constexpr double rock = 1.5;  // its width over its height, in pictures
  PanelGrid best{count, 1};
  double largest = 0;
  for (int columns = count; columns > 0; --columns) {
    const int rows = (count + columns - 1) / columns;
    const double high = std::min(width / columns / rock, height / rows);
    if (high <= largest) continue;
    largest = high;
    best = {columns, rows};
  }
  return best;
}

namespace {

constexpr int between_panels = 3;  // pixels between two of them

/// Where a panel begins along a side, pixels; that behind the last one: where the side ends, and a line more.
int begin_of(int panel, int panels, int side) { return panel * (side + between_panels) / panels; }

}  // namespace

std::vector<PanelPlace> panel_places(int count, int width, int height) {
  const auto [columns, rows] = panel_grid(count, width, height);
  std::vector<PanelPlace> places;
  for (int i = 0; i < count; ++i) {
    const int column = i % columns, row = i / columns, next = i + 1 < count ? column + 1 : columns;
    const int left = begin_of(column, columns, width), top = begin_of(row, rows, height);
    places.push_back({left, top, begin_of(next, columns, width) - left - between_panels,
                      begin_of(row + 1, rows, height) - top - between_panels});
  }
  return places;
}

}  // namespace talus
