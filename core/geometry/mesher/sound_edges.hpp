#pragma once

#include <vector>

#include "geometry/mesher_job.hpp"

namespace talus {

/// Throws InputError where an edge of a solid that was read is many times as long as the whole: gmsh would divide it
/// for ever. Edges of files that were looked at before are not looked at again.
void check_edge_lengths(const MesherSolid& solid, const std::vector<int>& volumes);

/// A damaged file may say in two ways that contradict each other where an edge runs: in space, and on the faces beside
/// it, and where it ends. gmsh meshes the one by the other, and its triangulation then goes round for ever. Throws
/// InputError where they are a hundredth of the whole apart. The volumes must be in gmsh's model (synchronized).
void check_edges_on_faces(const MesherSolid& solid, const std::vector<int>& volumes);

}  // namespace talus
