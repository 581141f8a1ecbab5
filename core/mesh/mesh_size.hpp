#pragma once

#include <span>

#include "mesh/tet_mesh.hpp"

namespace talus {

struct BlockSystem;

/// m, √(2 · mean triangle area): what penetration and the error of time integration are held to.
double mesh_size(std::span<const Vec3> nodes, std::span<const SurfaceTriangle> surface);

/// m, of the blocks that are not fixed; infinite where all are.
double smallest_mesh_size(const BlockSystem& system);

/// Whether what is `length` [m] long, with this surface [m²], is less than a mesh size across and very many of them
/// along: to mesh it takes time that grows with the square of its length, and nothing is right about it.
bool is_needle(double length, double area, double mesh_size);

}  // namespace talus
