#pragma once

#include <vector>

#include "geometry/mesher/surfaces/triangle_solid.hpp"

namespace talus {

/// Triangles that hang together in one plane: the number of its flat face for each triangle, from 0.
std::vector<int> flat_groups(const TriangleSolid& solid);

}  // namespace talus
