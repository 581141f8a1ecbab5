#pragma once

#include <vector>

#include "cases/known_case.hpp"

namespace talus {

/// One block on an incline: slides at Coulomb's acceleration, sticks below its friction angle whatever happens
/// elsewhere, stops where its energy is used up.
std::vector<KnownCase> sliding_cases();

}  // namespace talus
