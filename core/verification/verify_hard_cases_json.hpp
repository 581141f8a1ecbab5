#pragma once

#include <string>
#include <vector>

#include "verification/verify_hard_cases.hpp"

namespace talus {

/// Trials as JSON: {"passed", "scenes": [{"scene", "group", "title", "source", "expected", "status", "reason",
/// "seconds", "passed", "threads", "steps", "iterations_per_step", "most_iterations", "cuts", "penetration",
/// "energy_growth", "remainder", "least_volume", "interpenetration", "fingerprint", "faults", "known_shortfall",
/// "repetitions"}]}. A status is "completed", "not-converged" or "broken-off", with its reason. Penetration and
/// interpenetration are of the local mesh size, growth and remainder of the energy moved, the least volume of what the
/// tetrahedron had at the start. Runs with the same bits have the same "fingerprint", 16 hexadecimal digits.
/// "expected" and "faults" are lists of words. A repetition has "threads", "same_bits" and "reason". Numbers that are
/// not finite are null. "passed" is false where not all scenes that were asked for were run.
std::string json_text(const std::vector<Trial>& trials, bool complete = true);

/// The scenes there are: {"scenes": [{"scene", "group", "title", "source", "takes_long"}]}.
std::string list_json(const std::vector<HardCase>& scenes);

}  // namespace talus
