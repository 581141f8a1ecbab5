#pragma once

#include <string>
#include <vector>

#include "results/run_report.hpp"

/// steps.csv: what every step reports (docs/manual.md), one row a step.
namespace talus {

std::vector<std::string> steps_header();

std::vector<double> to_columns(const StepReport& step);
StepReport step_report(const std::vector<double>& columns);

}  // namespace talus
