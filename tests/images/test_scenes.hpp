#pragma once

#include <array>
#include <memory>
#include <string>

#include "mesh/block.hpp"
#include "results/frame.hpp"

namespace talus {

/// A block with the given corners (x fastest, then y, then z; of the unit cube's order), n cells a side,
/// each cut into six tetrahedra.
Block hexahedron(const std::string& name, const std::array<Vec3, 8>& corners, int n, BodyKind body);
Block box(const std::string& name, const Vec3& low, const Vec3& high, int n, BodyKind body);

/// Two boxes on a fixed plate: B1 at x 0…1, B2 at x 1…2, both 1 m wide and high, z from 0.
BlockSystem two_boxes();

/// A fixed slope that falls to the west at 30°, with a flat toe, and 4 × 3 blocks on it.
BlockSystem jointed_slope();

/// Every movable block of `jointed_slope` slid down by up to `distance` m, the lower ones farther; velocities along the
/// slope, a stress that grows with depth, and a contact below each block.
std::shared_ptr<Frame> slid(const BlockSystem& slope, double distance, double time);

}  // namespace talus
