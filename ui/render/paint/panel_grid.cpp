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

}  // namespace talus
