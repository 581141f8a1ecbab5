#pragma once

#include "stability/all_scenes.hpp"

/// Scenes of many blocks: those that stand or go in order, and those poured or packed into pits.
namespace talus {

std::vector<StabilityScene> standing_crowds();
std::vector<StabilityScene> crowds_in_pits();

inline const char* const crowd_group = "crowds";

}  // namespace talus
