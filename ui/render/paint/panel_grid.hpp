#pragma once

#include <vector>

namespace talus {

/// Pictures that stand beside each other: in rows, from left to right and downwards. The last one has the rest of its
/// row.
struct PanelGrid {
  int columns = 1, rows = 1;
  bool operator==(const PanelGrid&) const = default;
};

/// The one of so many pictures in `width` × `height` in which rock, which mostly is wider than high, is largest.
PanelGrid panel_grid(int count, double width, double height);

/// Where one of them stands; x to the right and y down from the left upper corner.
struct PanelPlace {
  int left = 0, top = 0, width = 0, height = 0;
};

/// The places of so many pictures in `width` × `height` pixels, with a line of three pixels between two of them.
std::vector<PanelPlace> panel_places(int count, int width, int height);

}  // namespace talus
