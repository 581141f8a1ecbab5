#pragma once

#include <vector>

#include "geometry/mesher_job.hpp"

namespace talus {

/// Whether the solid's file is IGES, which is to be read before any STEP file: that sets a unit that OpenCASCADE then
/// reads all files in.
bool is_iges(const MesherSolid& solid);

/// The volumes of a STEP, IGES or BREP file in gmsh's OpenCASCADE model, in metres and placed. Loose faces, as IGES
/// has them, are sewn together. Throws InputError for files that hold no closed solid.
std::vector<int> read_cad(const MesherSolid& solid);

}  // namespace talus
