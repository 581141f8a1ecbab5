#pragma once

#include <vector>

#include "geometry/mesh_estimate.hpp"
#include "geometry/mesher_job.hpp"

namespace talus {

/// What the project and, where it leaves the body open, the chooser say of the blocks that are cut and named; without
/// meshes. Throws InputError for what the project asks of blocks that are not there, or of bodies that cannot.
std::vector<Block> described_blocks(const Project& project, const MesherCutModel& cut);

/// How each block is to be meshed. Rigid and affine blocks need tetrahedra for their volume alone: where no size is
/// given for them they are meshed from their corners. So are fixed blocks of triangulated solids.
std::vector<BlockToMesh> blocks_to_mesh(const Project& project, const MesherCutModel& cut,
                                        const std::vector<Block>& blocks);

/// Whether a block is meshed from its corners alone. `wanted`: its override, null where it has none; `of_cells`: its
/// solid is triangles.
bool corners_suffice(BodyKind body, const Solid& solid, const BlockOverride* wanted, bool of_cells);

}  // namespace talus
