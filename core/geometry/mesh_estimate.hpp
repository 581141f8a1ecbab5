#pragma once

#include <span>

#include "geometry/block_builder.hpp"

namespace talus {

/// What meshing will come to, before it is done.
struct MeshEstimate {
  double tetrahedra = 0;
  double nodes = 0;
  double unknowns = 0;  ///< of the motion: 3 a node, 12 an affine block, 6 a rigid one
  double bytes = 0;     ///< that meshing holds at most
  double seconds = 0;   ///< that meshing takes
};

/// How a block is to be meshed, and what of its shape that depends on.
struct BlockToMesh {
  BodyKind body = BodyKind::tetrahedra;
  double size = 0;                              ///< m
  bool refined = false;                         ///< the refinements count for it
  double volume = 0;                            ///< m³
  double area = 0;                              ///< m²
  Vec3 min = Vec3::Zero(), max = Vec3::Zero();  ///< m, corners of the box around it
  bool of_cells = false;                        ///< its solid is triangles, whose corners all stay
  double corners = 8;                           ///< points where faces of three planes meet

  /// It gets a tetrahedron on each triangle between its corners, without gmsh. (Under rough ground, where its centroid
  /// does not see all of its surface, some times as many.)
  bool stands_on_corners() const { return of_cells && !refined; }
};

/// Counts are right to a fifth; memory and time are those of the machine
/// on which they were fitted. Rock fills the box around a block evenly, as far as refinements are concerned.
MeshEstimate mesh_estimate(std::span<const BlockToMesh> blocks, std::span<const MeshRefinement> refinements);

/// The same of all blocks as the project wants them meshed now; `cut`: its blocks, from `cut_blocks` or `build_blocks`.
MeshEstimate mesh_estimate(const Project& project, const BlockSystem& cut);

/// Whether the block is a needle under its mesh size (mesh/mesh_size.hpp).
bool is_needle(const BlockToMesh& block);

/// Throws InputError where there would be more tetrahedra than the project allows, or meshing would hold more memory
/// than there is.
void require_a_mesh_that_fits(const Project& project, const MeshEstimate& estimate);

}  // namespace talus
