#pragma once

#include <string>
#include <vector>

#include "effects/compose.hpp"
#include "results/run_report.hpp"
#include "study/reference_events.hpp"

namespace talus::cli {

/// What a run came to, for a reader: status, cost, blocks, effects, events and expectations.
std::string report_text(const RunReport& report);

/// Expected against computed.
std::string expectations_text(const std::vector<ExpectationOutcome>& outcomes);

/// Published against computed times.
std::string events_text(const std::vector<EventComparison>& comparisons);

std::string effects_text(const std::vector<EffectStatus>& effects);

}  // namespace talus::cli
