#pragma once

#include <vector>

#include "cases/known_case.hpp"

namespace talus {

/// A column that is let go on an edge, and dominoes.
std::vector<KnownCase> rocking_cases();

/// A block that falls and rebounds.
std::vector<KnownCase> bouncing_cases();

}  // namespace talus
