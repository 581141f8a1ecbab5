#pragma once

#include <functional>
#include <map>
#include <string_view>
#include <vector>

#include "geometry/mesher/plane_table.hpp"
#include "geometry/mesher/shape_import.hpp"

namespace talus {

/// What a face of a cut block lies on.
struct FacetOrigin {
  int plane = -1;  ///< index into CutModel::planes; −1: the face is curved
  int joint = -1;  ///< index into Project::joints; −1: on no cut
};

struct CutBlock {
  int solid = 0;
  int volume_tag = 0;                 ///< of gmsh's current model
  double volume = 0;                  ///< m³
  Vec3 centroid = Vec3::Zero();       ///< relative to the model's origin
  std::map<int, FacetOrigin> facets;  ///< by the face's gmsh tag
};

struct CutModel {
  PlaneTable planes;
  std::vector<CutBlock> blocks;  ///< by solid; within a solid by the centroid's x, then y, then z
};

/// Mesh size of a solid's blocks, m: as given, or a tenth of its longest side.
double mesh_size_of(const MesherSolid& solid, const ImportedSolid& imported);

/// Cuts every solid along the planes that pass through it and gives each facet the joint of the plane it lies on.
/// Throws InputError for a cut that misses, for two joints on one plane, and when a piece is thinner than 10⁻⁴ of the
/// mesh size.
CutModel cut_solids(const MesherJob& job, const ImportedModel& model,
                    const std::function<void(double, std::string_view)>& report);

}  // namespace talus
