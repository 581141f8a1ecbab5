#pragma once

#include "measures/slide.hpp"
#include "render/charts/charts.hpp"

namespace talus {

/// The velocity of the front, forward, over time.
HistoryPlot front_plot(const Slide& slide, Theme theme = Theme::light);

/// A map of the deposit's depth, north up, with its outline, that of the rock where it was, and the line from the crown
/// of the scar to the toe of the deposit. Throws std::invalid_argument where no rock has moved.
Painting deposit_map(const Slide& slide, Theme theme = Theme::light);

}  // namespace talus
