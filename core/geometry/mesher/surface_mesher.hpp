#pragma once

#include <array>
#include <span>
#include <vector>

#include "geometry/mesher/block_cutter.hpp"

namespace talus {

/// The triangles around a block, with nodes of their own. Their order and sense are gmsh's.
struct SurfaceMesh {
  std::vector<Vec3> nodes;  ///< m, relative to the model's origin
  std::vector<std::array<int, 3>> triangles;
  std::vector<FacetOrigin> origins;  ///< of each triangle
};

/// Triangulates the faces of every block of gmsh's current model; `sizes`: m, the length that each block's edges aim
/// at. Blocks of equal size have equal triangles on the joint between them. Nodes on flat facets lie on the table's
/// planes to the last digit.
std::vector<SurfaceMesh> mesh_surfaces(const CutModel& cut, std::span<const double> sizes);

}  // namespace talus
