#pragma once

#include <string>
#include <vector>

#include "verification/verify.hpp"

namespace talus {

/// Results as JSON: {"passed", "cases": [{"case", "title", "source", "status", "reason", "seconds", "passed", "scale",
/// "threads", "checks", "tables", "remarks", "repetitions"}]}. A status is "completed" or, where a case came to no
/// answer, "failed" with its reason. A check has "quantity", "unit", "expected", "computed", "error", "tolerance",
/// "absolute" (error and tolerance are in the unit, not relative), "held" (false: shown only) and "passed".
/// A repetition has "scale", "threads", "same_bits", "largest_difference" in "quantity", "about_zero" (differences of
/// numbers that should be zero, in units of their tolerance) in "quantity_about_zero", "reason" and "passed". Numbers
/// that are not finite are null. "passed" is false where not all cases that were asked for were run.
std::string json_text(const std::vector<CaseResult>& results, bool complete = true);

/// The cases there are: {"cases": [{"case", "title", "source", "takes_long"}]}.
std::string list_json(const std::vector<KnownCase>& cases);

}  // namespace talus
