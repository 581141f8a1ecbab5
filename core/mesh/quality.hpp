#pragma once

#include <functional>

#include "mesh/tet_mesh.hpp"

namespace talus {

/// How well shaped tetrahedra are: 3 × inscribed / circumscribed radius, 1 for a regular one, 0 for a flat one.
struct MeshQuality {
  double worst = 1, mean = 1;
  double smallest_dihedral = 180, largest_dihedral = 0;  ///< degrees between two faces of a tetrahedron
};

/// Degrees; 70.53 for all six of a regular tetrahedron, near 0 and 180 for a flat one.
struct DihedralRange {
  double smallest, largest;
};
DihedralRange tetrahedron_dihedrals(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

double tetrahedron_quality(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Of all tetrahedra; 1 where there are none. `each` is told the number, the quality and the dihedrals of every one.
using QualityVisit = std::function<void(std::size_t tetrahedron, double quality, const DihedralRange& dihedrals)>;
MeshQuality mesh_quality(const TetMesh& mesh, const QualityVisit& each = {});

}  // namespace talus
