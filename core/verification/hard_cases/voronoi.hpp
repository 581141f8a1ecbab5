#pragma once

#include <vector>

#include "mesh/tet_mesh.hpp"

namespace talus {

/// A box cut into the Voronoi cells of `count` points strewn evenly in it, one mesh a cell: those of what is nearer to
/// a point than to all others. The same for the same `seed` on every machine.
std::vector<TetMesh> voronoi_pieces(const Vec3& min, const Vec3& max, int count, unsigned seed);

/// A plane that takes away what lies where its normal (unit) points.
struct CuttingPlane {
  Vec3 point, normal;
};
/// The same cells without what the plane takes away; a cell that it takes wholly is none any more.
std::vector<TetMesh> voronoi_pieces(const Vec3& min, const Vec3& max, int count, unsigned seed,
                                    const CuttingPlane& plane);

}  // namespace talus
