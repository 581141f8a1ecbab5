#pragma once

#include "geometry/mesher/shape_import.hpp"

namespace talus {

/// Mesh size of a solid's blocks, m: as given, or a tenth of its longest side.
double mesh_size_of(const MesherSolid& solid, const ImportedSolid& imported);

/// m, 10⁻⁴ of the mesh size: a plane so near to a facet lies on it, and a piece so thin is a splinter.
double least_thickness(const MesherSolid& solid, const ImportedSolid& imported);

}  // namespace talus
