#pragma once

#include <string>
#include <vector>

#include "results/run_report.hpp"
#include "run/effect_costs.hpp"

namespace talus::cli {

/// Before a run: which effects are on and off, why, of what they are to be paid for and what that costs an iteration.
std::string costs_text(const std::vector<EffectCost>& costs);

/// What the answer hangs on where the project switches effects on or off, and what that costs, a line each; nothing
/// where it does not.
std::string switched_effects_text(const Project& project);

/// After a run: what its effects cost, the dearest first, which were off, and what it did, in counts. Empty of a report
/// that knows of no effects.
std::string profile_text(const RunReport& report);

}  // namespace talus::cli
