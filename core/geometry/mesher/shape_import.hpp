#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "geometry/mesher_job.hpp"

namespace talus {

/// A solid of the project in gmsh's current OpenCASCADE model, in coordinates relative to the model's origin.
struct ImportedSolid {
  std::vector<int> volumes;    ///< gmsh tags; a file may hold several
  Eigen::AlignedBox3d bounds;  ///< m
  double volume = 0;           ///< m³

  double longest_side() const { return bounds.sizes().maxCoeff(); }
};

struct ImportedModel {
  Vec3 origin = Vec3::Zero();  ///< add it to a coordinate to have the project's
  std::vector<ImportedSolid> solids;
};

/// Makes or reads every solid and shifts all to a common origin near their middle: volumes and intersections of
/// a site at 10⁶ m would otherwise lose six digits.
/// Throws InputError for polyhedra that are no closed body and for files that hold none.
ImportedModel import_solids(const std::vector<MesherSolid>& solids);

}  // namespace talus
