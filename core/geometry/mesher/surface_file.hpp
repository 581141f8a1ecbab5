#pragma once

#include "geometry/mesher/surfaces/mended_surface.hpp"
#include "geometry/mesher_job.hpp"

namespace talus {

/// Whether the solid's file has triangles (STL, OBJ, PLY, MSH) or is of a terrain, and not one of CAD.
bool has_surface_file(const MesherSolid& solid);

/// The surface of such a solid, placed and mended as far as can be. Throws InputError at the file.
MendedSurface read_surface(const MesherSolid& solid);

}  // namespace talus
