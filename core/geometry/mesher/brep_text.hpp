#pragma once

#include <string>

#include "geometry/mesher_job.hpp"

namespace talus {

/// Reads the text of a BREP file word by word, as OpenCASCADE does, which goes round for ever where a word is missing
/// or no number: every table has as many entries as it says, whatever is named by its number is there, and numbers are
/// finite. Source: "BRep Format" in OpenCASCADE's documentation, of versions 1 to 3. Throws InputError with the line
/// that is damaged. Does nothing for a file that does not begin as BREP at all: that reading it tells.
void check_brep_text(const MesherSolid& solid, std::string text);

}  // namespace talus
