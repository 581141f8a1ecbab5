#pragma once

#include <array>

#include "render/paint/colour.hpp"

namespace talus {

enum class Theme { light, dark };

/// Every colour a picture is drawn with, apart from the colour maps, which are the same in both themes.
struct ThemeColours {
  Rgb view_top, view_bottom;   ///< background gradient
  Rgb edge, rock, pick, warn;  ///< block edges; fixed rock; what is selected; where the run has trouble to converge
  Rgb text, muted, line;       ///< writing, lesser writing, ticks and axes
  Rgb surface, frame, grid;    ///< cards and paper, their frames, grid lines of plots
};

const ThemeColours& colours(Theme theme);

/// Paul Tol's "light" scheme without its orange, which means what is selected: for neighbouring blocks.
const std::array<Rgb, 7>& block_palette();

/// From what stays to what goes: five steps of caution, the last of them red.
const std::array<Rgb, 5>& caution_palette();

/// Curves and sets, each at least 3:1 against the theme's background.
const std::array<Rgb, 6>& curve_palette(Theme theme);

}  // namespace talus
