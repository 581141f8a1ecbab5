#pragma once

#include <string>
#include <vector>

#include "results/run_report.hpp"
#include "study/reference_events.hpp"

namespace talus::cli {

/// What a run came to, for a reader: status, cost, blocks, profile, events and expectations.
std::string report_text(const RunReport& report);

/// Expected against computed.
std::string expectations_text(const std::vector<ExpectationOutcome>& outcomes);

/// Published against computed times.
std::string events_text(const std::vector<EventComparison>& comparisons);

}  // namespace talus::cli
