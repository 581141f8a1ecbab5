#include "verification/reference_events.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>

#include "base/error.hpp"
#include "results/monitor_value.hpp"

namespace talus {

namespace {

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  if (!line.empty() && line.back() == ',') cells.emplace_back();
  return cells;
}

/// Parts of a row with the line they stand on, so that every complaint names it.
struct Row {
  std::string place;
  std::vector<std::string> cells;

  double number(std::size_t column) const {
    std::size_t end = 0;
    double value = 0;
    try {
      value = std::stod(cells[column], &end);
    } catch (const std::exception&) {
      end = 0;
    }
    if (end == 0 || end != cells[column].size())
      throw InputError(place, "'" + cells[column] + "' is no number", "write it like 45 or 4.5e1");
    return value;
  }

  Quantity quantity(std::size_t column) const {
    const auto quantity = parse_quantity(cells[column]);
    if (!quantity) throw InputError(place, "'" + cells[column] + "' is no quantity", "write it like P1.displacement.y");
    return *quantity;
  }
};

ReferenceEvent event_of(const Row& row) {
  if (row.cells.size() != 5)
    throw InputError(row.place, "has " + std::to_string(row.cells.size()) + " columns",
                     "give time,event,quantity,minus,reaches");
  ReferenceEvent event{row.number(0), row.cells[1], row.quantity(2), std::nullopt, row.number(4), row.cells[2]};
  if (!row.cells[3].empty()) {
    event.minus = row.quantity(3);
    event.criterion += " − " + row.cells[3];
  }
  event.criterion += " ≥ " + row.cells[4];
  return event;
}

double value_of(const Quantity& quantity, const std::vector<std::string>& monitors, const HistoryRow& row) {
  const auto found = std::find(monitors.begin(), monitors.end(), quantity.of);
  if (found == monitors.end())
    throw InputError("event quantity " + quantity.of, "the results hold no monitor of that name",
                     "name one of the project's monitors");
  const MonitorSample& sample = row.monitors[static_cast<std::size_t>(found - monitors.begin())];
  return component_of(field_value(sample, quantity.field), quantity.component);
}

/// The time at which a line through two points comes to `level`.
double crossing(double t0, double v0, double t1, double v1, double level) {
  return v1 > v0 ? t0 + (t1 - t0) * (level - v0) / (v1 - v0) : t1;
}

EventComparison compare(const ReferenceEvent& event, const std::vector<std::string>& monitors,
                        std::span<const HistoryRow> history) {
  EventComparison comparison{event, std::nullopt, std::nullopt};
  double last_time = 0, last_value = 0;
  for (const HistoryRow& row : history) {
    double value = value_of(event.quantity, monitors, row);
    if (event.minus) value -= value_of(*event.minus, monitors, row);
    const bool first = &row == &history.front();
    if (!comparison.computed && value >= event.reaches)
      comparison.computed = first ? row.time : crossing(last_time, last_value, row.time, value, event.reaches);
    if (!comparison.value_then && row.time >= event.time) {
      const double share = first || row.time <= last_time ? 1 : (event.time - last_time) / (row.time - last_time);
      comparison.value_then = first ? value : last_value + share * (value - last_value);
    }
    last_time = row.time;
    last_value = value;
  }
  return comparison;
}

}  // namespace

std::vector<ReferenceEvent> read_reference_events(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) throw InputError(file.string(), "cannot be read", "check the path");
  std::vector<ReferenceEvent> events;
  int number = 0;
  bool heading = true;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.empty() || line.front() == '#') continue;
    if (heading)
      heading = false;
    else
      events.push_back(event_of({file.string() + ": line " + std::to_string(number), cells_of(line)}));
  }
  std::stable_sort(events.begin(), events.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
  return events;
}

std::vector<EventComparison> compare_events(std::span<const ReferenceEvent> events,
                                            const std::vector<std::string>& monitor_names,
                                            std::span<const HistoryRow> history) {
  std::vector<EventComparison> comparisons;
  for (const ReferenceEvent& event : events) comparisons.push_back(compare(event, monitor_names, history));
  return comparisons;
}

bool in_published_order(std::span<const EventComparison> comparisons) {
  double last = -1;
  for (const EventComparison& comparison : comparisons) {
    if (!comparison.computed || *comparison.computed < last) return false;
    last = *comparison.computed;
  }
  return true;
}

}  // namespace talus
