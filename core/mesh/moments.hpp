#pragma once

#include "mesh/tet_mesh.hpp"

namespace talus {

/// Volume integrals of a mesh of tetrahedra of one density.
struct VolumeMoments {
  double volume = 0;             ///< m³
  Vec3 centroid = Vec3::Zero();  ///< m
  Mat3 spread = Mat3::Zero();    ///< m², mean of (x − c)(x − c)ᵀ
};

/// Exact for the mesh; all zero where it has no tetrahedra.
VolumeMoments volume_moments(const TetMesh& mesh);

}  // namespace talus
