#pragma once

#include "verification/hard_cases/scenes/scene_groups.hpp"

/// Scenes of many blocks: those that stand or go in order, and those poured or packed into pits.
namespace talus {

std::vector<HardCase> standing_crowds();
std::vector<HardCase> crowds_in_pits();

inline const char* const crowd_group = "crowds";

}  // namespace talus
