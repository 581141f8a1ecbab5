#pragma once

#include <vector>

#include "geometry/mesher_job.hpp"

namespace talus {

/// Where a point of a solid's shape lies.
Vec3 placed(const MesherPlacement& placement, const Vec3& point);

/// The same of volumes of gmsh's OpenCASCADE model.
void place_volumes(const MesherPlacement& placement, const std::vector<int>& volumes);

/// For shapes whose coordinates are relative to `origin`, a point of the project.
MesherPlacement relative_to(const Vec3& origin, MesherPlacement placement);

}  // namespace talus
