#pragma once

#include <span>

#include "mesh/tet_mesh.hpp"

namespace talus {

struct BlockSystem;

/// m, √(2 · mean triangle area): what penetration and the error of time integration are held to.
double mesh_size(std::span<const Vec3> nodes, std::span<const SurfaceTriangle> surface);

/// m, of the blocks that are not fixed; infinite where all are.
double smallest_mesh_size(const BlockSystem& system);

}  // namespace talus
