#pragma once

#include "measures/block_history.hpp"
#include "render/charts/charts.hpp"

namespace talus {

/// Curves that a chart tells apart.
inline constexpr std::size_t most_curves = 6;

/// A quantity over time, a curve a block.
HistoryPlot block_plot(const BlockHistory& history, const BlockQuantity& quantity);

}  // namespace talus
