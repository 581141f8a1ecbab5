#pragma once

#include <span>
#include <string>

#include "orientation/kinematics.hpp"
#include "orientation/set_statistics.hpp"

namespace talus::cli {

/// A table of sets: poles, mean plane, κ, cones.
std::string sets_text(std::span<const SetStatistics> sets);

/// How many poles and intersections are critical in the face.
std::string kinematics_text(const KinematicCounts& counts, const KinematicSetting& setting);

}  // namespace talus::cli
