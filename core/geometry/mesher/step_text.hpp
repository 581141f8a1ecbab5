#pragma once

#include <string_view>

#include "geometry/mesher_job.hpp"

namespace talus {

/// Where an edge runs on a face around an axis, the text of a damaged STEP file may say with an angle of milliards of
/// turns: OpenCASCADE finds the ends of such an edge among as many places, for ever. Throws InputError with the line of
/// a point on such a face whose angle, in the file's unit, is beyond a million.
void check_step_text(const MesherSolid& solid, std::string_view text);

}  // namespace talus
