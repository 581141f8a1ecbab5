#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <string_view>
#include <vector>

#include "geometry/mesher/surfaces/triangle_solid.hpp"
#include "geometry/mesher_job.hpp"
#include "geometry/surface_finding.hpp"

namespace talus {

/// A solid of the project in coordinates relative to the model's origin: volumes of gmsh's current OpenCASCADE model;
/// or triangles where there are too many for that; or a convex polyhedron whose blocks need no mesh inside. A part of a
/// combined solid that is to be cut has none of them.
struct ImportedSolid {
  std::vector<int> volumes;  ///< gmsh tags; a file may hold several
  TriangleSolid triangles;
  PolyhedronShape convex;                ///< with flat faces
  Eigen::AlignedBox3d bounds;            ///< m
  double volume = 0;                     ///< m³
  std::vector<SurfaceFinding> findings;  ///< in the project's coordinates

  bool is_body() const { return !volumes.empty() || is_cells(); }
  /// It is cut as convex cells, without OpenCASCADE.
  bool is_cells() const { return !triangles.empty() || !convex.faces.empty(); }
  double longest_side() const { return bounds.sizes().maxCoeff(); }
};

struct ImportedModel {
  Vec3 origin = Vec3::Zero();  ///< add it to a coordinate to have the project's
  std::vector<ImportedSolid> solids;
};

/// To be cut: parts of combined solids are used up, surfaces must be sound, those of few flat faces become volumes. Or
/// to be looked at: all stay, as they come.
enum class ImportPurpose { cut, look };

/// Makes, reads or combines every solid and shifts all to a common origin near their middle: volumes and intersections
/// of a site at 10⁶ m would otherwise lose six digits.
/// Throws InputError for polyhedra that are no closed body and for files that hold none.
ImportedModel import_solids(const std::vector<MesherSolid>& solids, ImportPurpose purpose,
                            const std::function<void(double, std::string_view)>& report);

}  // namespace talus
