#pragma once

#include <string_view>

#include "geometry/mesher_job.hpp"

namespace talus {

/// What makes OpenCASCADE read a damaged STEP file for ever, or until it has no memory left: an edge, or another part
/// of a shell, that is part of itself; and where an edge runs on a face around an axis, an angle of milliards of turns,
/// among which it looks for the ends of the edge. Throws InputError with the line of the part, or of a point on such a
/// face whose angle, in the file's unit, is beyond a million.
void check_step_text(const MesherSolid& solid, std::string_view text);

}  // namespace talus
