#include "render/charts/block_plot.hpp"

#include <algorithm>
#include <cmath>

#include "render/paint/numbers.hpp"
#include "render/paint/picture_words.hpp"

namespace talus {

HistoryPlot block_plot(const BlockHistory& history, const BlockQuantity& quantity) {
  HistoryPlot plot;
  plot.title = picture_word(quantity.title);
  plot.y_title = picture_word(quantity.title);
  double largest = 0;
  for (std::size_t i = 0; i < history.blocks.size(); ++i) {
    plot.series.push_back({.name = history.names[i], .x = history.times, .y = history.values(i, quantity)});
    for (const double value : plot.series.back().y)
      if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  }
  const DisplayUnit unit = display_unit(quantity.unit, largest);
  plot.y_unit = unit.name;
  for (Series& series : plot.series)
    for (double& y : series.y) y *= unit.factor;
  return plot;
}

}  // namespace talus
