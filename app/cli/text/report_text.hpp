#pragma once

#include <string>
#include <vector>

#include "results/run_report.hpp"
#include "verification/reference_events.hpp"

namespace talus::cli {

/// What a run came to, for a reader: status, cost, blocks, profile, events, expectations, and
/// where it was hard.
std::string report_text(const RunReport& report);

/// Where the run was hard: contact, joint, place, what it took and what to change; nothing where it was easy.
std::string troubles_text(const std::vector<ConvergenceTrouble>& troubles);

/// Expected against computed.
std::string expectations_text(const std::vector<ExpectationOutcome>& outcomes);

/// Published against computed times.
std::string events_text(const std::vector<EventComparison>& comparisons);

}  // namespace talus::cli
