#pragma once

#include <string>
#include <vector>

#include "results/run_report.hpp"

/// history.csv: time, stage (counted from 0) and, for each monitor, displacement and velocity.
namespace talus {

/// "time [s]", "stage", "P1.displacement.x [m]" … "P1.velocity.z [m/s]", the next monitor's.
std::vector<std::string> history_header(const std::vector<std::string>& monitors);

std::vector<double> to_columns(const HistoryRow& row);
HistoryRow history_row(const std::vector<double>& columns);

}  // namespace talus
