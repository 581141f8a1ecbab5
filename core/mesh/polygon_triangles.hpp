#pragma once

#include <array>
#include <vector>

#include "base/vector.hpp"

namespace talus {

/// Triangles that fill a flat polygon without holes, convex or not, turning as it does: n − 2 of its n corners (ear
/// clipping; Meisters 1975). `face`: vertex numbers in order.
std::vector<std::array<int, 3>> polygon_triangles(const std::vector<Vec3>& vertices, std::vector<int> face);

}  // namespace talus
