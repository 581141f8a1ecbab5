#pragma once

#include <vector>

#include "verification/known_answers/support/known_case.hpp"

namespace talus {

/// What tetrahedra must do as a continuum: patch tests, beam, wave, crack.
std::vector<KnownCase> continuum_cases();

// The groups that it joins, a file each.
std::vector<KnownCase> free_fall_cases();
std::vector<KnownCase> patch_test_cases();
std::vector<KnownCase> beam_cases();
std::vector<KnownCase> wave_cases();
std::vector<KnownCase> spin_cases();
std::vector<KnownCase> spring_cases();
std::vector<KnownCase> pinned_bar_cases();
std::vector<KnownCase> crack_cases();

}  // namespace talus
