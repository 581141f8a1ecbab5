#pragma once

#include <array>
#include <span>
#include <vector>

#include "geometry/mesher/cut_block.hpp"
#include "geometry/mesher/plane_table.hpp"
#include "geometry/mesher_job.hpp"

namespace talus {

/// The triangles around a block, with nodes of their own. Their order and sense are gmsh's.
struct SurfaceMesh {
  std::vector<Vec3> nodes;  ///< m, relative to the model's origin
  std::vector<std::array<int, 3>> triangles;
  std::vector<FacetOrigin> origins;  ///< of each triangle
};

/// Triangulates the faces of every block of gmsh's current model, as finely as `sizes` say, a block each. Blocks of
/// equal size have equal triangles on the joint between them. Nodes on flat facets lie on the table's planes to the
/// last digit. `refinements`: relative to the model's origin.
std::vector<SurfaceMesh> mesh_surfaces(std::span<const NamedBlock> blocks, const PlaneTable& planes,
                                       std::span<const MesherSize> sizes, std::span<const MeshRefinement> refinements);

}  // namespace talus
