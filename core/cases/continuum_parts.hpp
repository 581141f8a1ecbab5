#pragma once

#include "cases/known_case.hpp"

/// The groups that continuum_cases() joins, a file each.
namespace talus {

std::vector<KnownCase> free_fall_cases();
std::vector<KnownCase> patch_test_cases();
std::vector<KnownCase> beam_cases();
std::vector<KnownCase> wave_cases();
std::vector<KnownCase> spin_cases();
std::vector<KnownCase> spring_cases();
std::vector<KnownCase> pinned_bar_cases();
std::vector<KnownCase> crack_cases();

}  // namespace talus
