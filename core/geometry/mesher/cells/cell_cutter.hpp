#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "geometry/mesher/acting_joints.hpp"
#include "geometry/mesher/cells/cell_solid.hpp"
#include "geometry/mesher/cut_block.hpp"
#include "geometry/mesher/shape_import.hpp"

namespace talus {

struct CutCells {
  CellSolid solid;
  std::vector<CutBlock> blocks;  ///< by the centroid's x, then y, then z; their facets have negative tags
  std::vector<bool> hit;         ///< of each joint: it divides the solid or lies on one of its faces
};

/// Cuts a triangulated or convex solid along planes without end: cell by cell, then cells that no joint parts are one
/// block. `solid`: index into the job's; `first_tag`: negative, below the tags of all facets so far. Throws InputError
/// for joints that end, and where volume is lost. `report`: the fraction of the joints that have cut.
CutCells cut_cells(const MesherJob& job, const ImportedModel& model, int solid, const std::vector<ActingJoint>& joints,
                   int first_tag, const std::function<void(double)>& report);

}  // namespace talus
