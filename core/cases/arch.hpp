#pragma once

#include <vector>

#include "cases/known_case.hpp"

namespace talus {

/// The semicircular arch under its own weight: runs just above and just below its least thickness.
std::vector<KnownCase> arch_cases();

}  // namespace talus
