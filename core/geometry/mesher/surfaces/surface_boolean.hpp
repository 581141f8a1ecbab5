#pragma once

#include <string>
#include <vector>

#include "geometry/mesher/surfaces/mended_surface.hpp"
#include "model/rock/solid.hpp"

namespace talus {

/// The solids united or intersected, or the others taken from the first, by exact arithmetic that is rounded once at
/// the end. Throws InputError at `place` when nothing is left, or bodies would touch in a line or a point alone.
MendedSurface combined(CombineOperation operation, const std::vector<TriangleSolid>& parts, const std::string& place);

}  // namespace talus
