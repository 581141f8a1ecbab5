#pragma once

#include <vector>

#include "mesh/tet_mesh.hpp"

namespace talus {

/// A box cut into the Voronoi cells of `count` points strewn evenly in it, one mesh a cell: those of what is nearer to
/// a point than to all others. The same for the same `seed` on every machine.
std::vector<TetMesh> voronoi_pieces(const Vec3& min, const Vec3& max, int count, unsigned seed);

}  // namespace talus
