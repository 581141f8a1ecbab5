#pragma once

#include <vector>

#include "verification/hard_cases/hard_case.hpp"

/// The groups that hard_cases() joins beside the classic scenes.
namespace talus {

std::vector<HardCase> degenerate_scenes();
std::vector<HardCase> ratio_scenes();
std::vector<HardCase> odd_shape_scenes();
std::vector<HardCase> time_scenes();
std::vector<HardCase> crowd_scenes();
std::vector<HardCase> jointed_slopes();
std::vector<HardCase> state_change_scenes();
std::vector<HardCase> threshold_scenes();
std::vector<HardCase> found_scenes();

}  // namespace talus
