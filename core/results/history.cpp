#include "results/history.hpp"

namespace talus {

namespace {

constexpr std::size_t before_monitors = 2, a_monitor = 6;

}  // namespace

std::vector<std::string> history_header(const std::vector<std::string>& monitors) {
  std::vector<std::string> header = {"time [s]", "stage"};
  for (const std::string& monitor : monitors)
    for (const auto& [quantity, unit] : {std::pair{".displacement.", " [m]"}, std::pair{".velocity.", " [m/s]"}})
      for (const char* component : {"x", "y", "z"}) header.push_back(monitor + quantity + component + unit);
  return header;
}

std::vector<double> to_columns(const HistoryRow& row) {
  std::vector<double> columns = {row.time, static_cast<double>(row.stage)};
  for (const MonitorSample& monitor : row.monitors) {
    columns.insert(columns.end(), monitor.displacement.begin(), monitor.displacement.end());
    columns.insert(columns.end(), monitor.velocity.begin(), monitor.velocity.end());
  }
  return columns;
}

HistoryRow history_row(const std::vector<double>& columns) {
  HistoryRow row{.time = columns[0], .stage = static_cast<int>(columns[1]), .monitors = {}};
  for (std::size_t i = before_monitors; i + a_monitor <= columns.size(); i += a_monitor)
    row.monitors.push_back(
        {Vec3(columns[i], columns[i + 1], columns[i + 2]), Vec3(columns[i + 3], columns[i + 4], columns[i + 5])});
  return row;
}

}  // namespace talus
