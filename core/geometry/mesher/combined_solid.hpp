#pragma once

#include <string>

#include "geometry/mesher/shape_import.hpp"

namespace talus {

/// A solid of parts that are shifted to the model's origin already, not placed yet: of volumes where all of them are
/// (through OpenCASCADE), else of triangles. With `keep_parts` they stay as they are, else their volumes are used up.
/// `place` names it. Throws InputError where nothing is left or a part's surface is not sound.
ImportedSolid combine(const MesherCombination& combination, ImportedModel& model, bool keep_parts,
                      const std::string& place);

}  // namespace talus
