#pragma once

#include "measures/slide.hpp"
#include "render/charts/charts.hpp"

namespace talus {

/// The velocity of the front, forward, over time.
HistoryPlot front_plot(const Slide& slide, Theme theme = Theme::light);

/// A map of the deposit's depth, with its outline, that of the rock where it was, and the line from the crown of the
/// scar to the toe of the deposit. North is up; where the ground is long from south to north it is at the right, and an
/// arrow says so. Throws std::invalid_argument where no rock has moved.
Painting deposit_map(const Slide& slide, Theme theme = Theme::light);

/// Pixels that a map of this width needs for ground that lies with its long side across.
double deposit_map_height(const Slide& slide, double width);

}  // namespace talus
