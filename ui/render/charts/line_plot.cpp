#include "render/charts/line_plot.hpp"

#include <algorithm>
#include <cmath>

#include "render/paint/numbers.hpp"
#include "render/paint/picture_words.hpp"

namespace talus {

HistoryPlot line_plot(const LineProbe& probe, const Field& field, const std::string& title) {
  HistoryPlot plot;
  plot.title = title;
  plot.x_title = picture_word("Distance along the line");
  plot.x_unit = "m";
  plot.y_title = picture_word(field.title);
  LineProbe::Curve curve = probe.curve();
  double largest = 0;
  for (const double value : curve.values)
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  const DisplayUnit unit = display_unit(field.unit, largest);
  plot.y_unit = unit.name;
  for (double& value : curve.values) value *= unit.factor;
  plot.series.push_back({.name = "", .x = std::move(curve.along), .y = std::move(curve.values)});
  return plot;
}

}  // namespace talus
