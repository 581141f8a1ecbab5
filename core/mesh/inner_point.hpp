#pragma once

#include "mesh/tet_mesh.hpp"

namespace talus {

/// A point well inside a block [m]: the centre of the largest ball that lies in one of its tetrahedra. That is inside
/// whatever shape the block has, as the middle of all its nodes is not. Throws std::invalid_argument for a mesh without
/// tetrahedra.
Vec3 inner_point(const TetMesh& mesh);

}  // namespace talus
