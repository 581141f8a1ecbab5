#pragma once

#include <vector>

#include "model/rules/project_problems.hpp"

namespace talus {

/// What the answer of a run hangs on where its project switches an effect on or off, and what that costs: warnings for
/// the first, hints for the second.
std::vector<ProjectProblem> problems_of_switched_effects(const Project& project);

}  // namespace talus
