#pragma once

#include <string>
#include <vector>

#include "results/run_report.hpp"

/// history.csv: time, stage (counted from 0) and, for each monitor, displacement, velocity and, where it records it,
/// stress.
namespace talus {

/// A monitor as far as its columns go.
struct HistoryMonitor {
  std::string name;
  bool stress = false;
};

/// "time [s]", "stage", "P1.displacement.x [m]" … "P1.velocity.z [m/s]", with stress "P1.stress.xx [Pa]" …
/// "P1.stress.zx [Pa]", the next monitor's.
std::vector<std::string> history_header(const std::vector<HistoryMonitor>& monitors);

/// In the header's order, where each monitor that records stress has one.
std::vector<double> to_columns(const HistoryRow& row);
HistoryRow history_row(const std::vector<double>& columns, const std::vector<HistoryMonitor>& monitors);

}  // namespace talus
