#pragma once

#include <span>
#include <string>
#include <vector>

#include "measures/slipped_faces.hpp"
#include "orientation/set_statistics.hpp"

namespace talus {

/// The planes on which blocks slid on each other, as they were at rest, for a net: each of a set by its joint's name,
/// of none where they lay against each other on no joint. `joint_names`: of the system.
std::vector<MeasuredJoint> joints_that_slipped(std::span<const SlippedFace> faces,
                                               const std::vector<std::string>& joint_names);

}  // namespace talus
