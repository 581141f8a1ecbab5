#pragma once

#include <vector>

#include "cases/known_case.hpp"

namespace talus {

/// A column that is let go on an edge, and dominoes.
std::vector<KnownCase> rocking_cases();

}  // namespace talus
