#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/quantity.hpp"
#include "results/run_report.hpp"

namespace talus {

/// An event that a publication reports, and when a history counts as having come to it: as soon as `quantity`, less
/// `minus` where that is given, has reached `reaches`.
struct ReferenceEvent {
  double time = 0;  ///< s, as published
  std::string what;
  Quantity quantity;
  std::optional<Quantity> minus;
  double reaches = 0;     ///< m, m/s or Pa
  std::string criterion;  ///< in words: "P2.displacement.y − P1.displacement.y ≥ 5"
};

/// Reads `time,event,quantity,minus,reaches` rows after a heading; lines that begin with # are comments. Quantities
/// are monitors' ("P1.displacement.y"). Throws InputError that names the line.
std::vector<ReferenceEvent> read_reference_events(const std::filesystem::path& file);

struct EventComparison {
  ReferenceEvent event;
  std::optional<double> computed;    ///< s, between two rows by linear interpolation; empty: it did not happen
  std::optional<double> value_then;  ///< m, m/s or Pa, at the published time; empty: the history ends before
};

/// Throws InputError for a quantity of a monitor that is not in `monitor_names`.
std::vector<EventComparison> compare_events(std::span<const ReferenceEvent> events,
                                            const std::vector<std::string>& monitor_names,
                                            std::span<const HistoryRow> history);

/// Whether all of them happened, in the order of their published times.
bool in_published_order(std::span<const EventComparison> comparisons);

}  // namespace talus
