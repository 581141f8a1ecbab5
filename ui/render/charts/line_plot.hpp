#pragma once

#include <string>

#include "measures/line_probe.hpp"
#include "render/charts/charts.hpp"

namespace talus {

/// A field along a line, against the distance from its start.
HistoryPlot line_plot(const LineProbe& probe, const Field& field, const std::string& title);

}  // namespace talus
