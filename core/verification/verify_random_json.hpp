#pragma once

#include <string>
#include <vector>

#include "verification/hard_cases/trial.hpp"

namespace talus {

/// Random scenes as JSON: what hard cases are (verify_hard_cases_json.hpp), and before them "families": [{"family",
/// "scenes", "held", "seconds", "faults"}], where "faults" has, by kind, in how many scenes there was one.
std::string random_json_text(const std::vector<Trial>& trials, bool complete = true);

/// The families there are: {"families": [{"family", "title"}]}.
std::string family_list_json();

}  // namespace talus
