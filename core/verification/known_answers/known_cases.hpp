#pragma once

#include <vector>

#include "verification/known_answers/support/known_case.hpp"

namespace talus {

/// All cases with a known answer, from single blocks to whole series of tests. Names are unique.
std::vector<KnownCase> known_cases();

}  // namespace talus
