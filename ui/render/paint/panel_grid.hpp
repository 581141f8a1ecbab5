#pragma once

namespace talus {

/// Pictures that stand beside each other: in rows, from left to right and downwards. The last one has the rest of its
/// row.
struct PanelGrid {
  int columns = 1, rows = 1;
  bool operator==(const PanelGrid&) const = default;
};

/// The one of so many pictures in `width` × `height` in which rock, which mostly is wider than high, is largest.
PanelGrid panel_grid(int count, double width, double height);

}  // namespace talus
