#pragma once

#include "geometry/mesher/shape_import.hpp"
#include "geometry/solid_surface.hpp"

namespace talus {

/// What a solid that was imported to be looked at looks like, in the project's coordinates.
SolidSurface surface_of(const MesherSolid& solid, const ImportedSolid& imported, const Vec3& origin);

}  // namespace talus
