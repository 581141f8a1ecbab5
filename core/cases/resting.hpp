#pragma once

#include <vector>

#include "cases/known_case.hpp"

namespace talus {

/// Blocks that must stay, or stay just so: a slope of many blocks, bricks that overhang, cards that lean.
std::vector<KnownCase> resting_cases();

}  // namespace talus
