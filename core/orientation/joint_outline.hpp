#pragma once

#include <vector>

#include "model/project.hpp"

namespace talus {

/// Sides of the polygon that stands for a disc.
inline constexpr int sides_of_disc = 24;

/// Corners of a joint that ends, in order, on its plane: of a disc a regular polygon of the same area about the same
/// centre, of a polygon its corners put onto the plane along its normal. Empty for a plane without end. Where it ends
/// at other joints is not looked at. `joint`: one of `single_planes`.
std::vector<Vec3> outline_of(const Cut& joint);

}  // namespace talus
