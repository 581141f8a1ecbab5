#pragma once

#include "stability/stability_scene.hpp"

namespace talus {

/// The whole suite, group after group.
std::vector<StabilityScene> stability_scenes();

// A group each.
std::vector<StabilityScene> degenerate_scenes();
std::vector<StabilityScene> classic_scenes();
std::vector<StabilityScene> ratio_scenes();
std::vector<StabilityScene> odd_shape_scenes();
std::vector<StabilityScene> time_scenes();
std::vector<StabilityScene> crowd_scenes();
std::vector<StabilityScene> state_change_scenes();
std::vector<StabilityScene> threshold_scenes();

}  // namespace talus
