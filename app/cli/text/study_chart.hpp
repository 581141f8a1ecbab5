#pragma once

#include "render/charts/cost_chart.hpp"
#include "study/accuracy/accuracy.hpp"

namespace talus::cli {

/// The chart of a study, of those runs that have an error. Throws InputError where none has.
CostPlot cost_plot(const AccuracyStudy& study, Theme theme);

}  // namespace talus::cli
