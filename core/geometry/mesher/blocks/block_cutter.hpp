#pragma once

#include <functional>
#include <map>
#include <string_view>
#include <vector>

#include "geometry/mesher/cells/cell_solid.hpp"
#include "geometry/mesher/cut_block.hpp"
#include "geometry/mesher/plane_table.hpp"
#include "geometry/mesher/shape_import.hpp"

namespace talus {

/// All solids as joints have cut them.
struct CutModel {
  PlaneTable planes;
  std::vector<CutBlock> blocks;    ///< by solid; within a solid by the centroid's x, then y, then z
  std::map<int, CellSolid> cells;  ///< of solids that are triangles, by their index
  std::vector<MesherEndings> endings;
};

/// Cuts every solid along the planes that pass through it and gives each facet the joint of the plane it lies on.
/// Throws InputError for a cut that misses and for two joints on one plane.
CutModel cut_solids(const MesherJob& job, const ImportedModel& model,
                    const std::function<void(double, std::string_view)>& report);

}  // namespace talus
