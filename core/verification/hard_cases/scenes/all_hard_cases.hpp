#pragma once

#include <vector>

#include "verification/hard_cases/hard_case.hpp"

namespace talus {

/// All hard cases, group after group.
std::vector<HardCase> hard_cases();

}  // namespace talus
