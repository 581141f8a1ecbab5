#pragma once

#include "geometry/mesher/shape_import.hpp"

namespace talus {

/// Throws InputError that names both solids and the place where two of them share rock. Solids that touch, also with
/// coordinates rounded to five digits, do not overlap.
void check_no_overlap(const ImportedModel& model, const std::vector<MesherSolid>& solids);

}  // namespace talus
