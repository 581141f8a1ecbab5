#include "results/history.hpp"

namespace talus {

namespace {

void append(std::vector<double>& columns, const auto& vector) {
  columns.insert(columns.end(), vector.begin(), vector.end());
}

/// The next numbers of a row.
template <class Vector>
Vector take(const double*& column) {
  const Vector vector = Eigen::Map<const Vector>(column);
  column += vector.size();
  return vector;
}

}  // namespace

std::vector<std::string> history_header(const std::vector<HistoryMonitor>& monitors) {
  std::vector<std::string> header = {"time [s]", "stage"};
  for (const HistoryMonitor& monitor : monitors) {
    for (const auto& [quantity, unit] : {std::pair{".displacement.", " [m]"}, std::pair{".velocity.", " [m/s]"}})
      for (const char* component : {"x", "y", "z"}) header.push_back(monitor.name + quantity + component + unit);
    if (!monitor.stress) continue;
    for (const char* component : {"xx", "yy", "zz", "xy", "yz", "zx"})
      header.push_back(monitor.name + ".stress." + component + " [Pa]");
  }
  return header;
}

std::vector<double> to_columns(const HistoryRow& row) {
  std::vector<double> columns = {row.time, static_cast<double>(row.stage)};
  for (const MonitorSample& monitor : row.monitors) {
    append(columns, monitor.displacement);
    append(columns, monitor.velocity);
    if (monitor.stress) append(columns, *monitor.stress);
  }
  return columns;
}

HistoryRow history_row(const std::vector<double>& columns, const std::vector<HistoryMonitor>& monitors) {
  HistoryRow row{.time = columns[0], .stage = static_cast<int>(columns[1]), .monitors = {}};
  const double* column = columns.data() + 2;
  for (const HistoryMonitor& monitor : monitors) {
    MonitorSample& sample = row.monitors.emplace_back();
    sample.displacement = take<Vec3>(column);
    sample.velocity = take<Vec3>(column);
    if (monitor.stress) sample.stress = take<Voigt>(column);
  }
  return row;
}

}  // namespace talus
