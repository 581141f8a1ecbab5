#pragma once

#include <array>

#include "mesh/tet_mesh.hpp"

/// Meshes that need no mesher: known cases and tests want the same tetrahedra on every machine.
namespace talus {

/// nx × ny × nz cells of a hexahedron [m], each cell six tetrahedra (Kuhn's split); the mapping is trilinear. Corners
/// in the order of bits: corner 1 is along x, 2 along y, 4 along z. `mirrored` turns the diagonals the other way, so
/// that meshes of two blocks do not match. Throws std::invalid_argument for a hexahedron that is turned inside out.
TetMesh hexahedron_mesh(const std::array<Vec3, 8>& corners, int nx, int ny, int nz, bool mirrored = false);

/// The same for a box with its edges along the axes.
TetMesh box_mesh(const Vec3& min, const Vec3& max, int nx, int ny, int nz, bool mirrored = false);

/// Every tetrahedron into eight by the middles of its edges.
TetMesh refined(const TetMesh& mesh);

/// The faces that belong to one tetrahedron only, counter-clockwise seen from outside, on no joint.
std::vector<SurfaceTriangle> boundary(const TetMesh& mesh);

/// Sum of the tetrahedra [m³].
double volume(const TetMesh& mesh);

}  // namespace talus
