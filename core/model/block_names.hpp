#pragma once

#include <string>
#include <vector>

#include "base/error.hpp"
#include "model/project.hpp"

namespace talus {

/// Whether geometry may give a block this name: that of an override, that of a solid left whole, or
/// "solid.1", "solid.2" … for the pieces of one that is cut or imported in several bodies.
bool may_be_block_name(const Project& project, const std::string& name);

/// The names a block may have, for suggestions: overrides and solids (the number of pieces is not known yet).
std::vector<std::string> expected_block_names(const Project& project);

/// What is wrong with `place`, which names the block and says a point that is not in it.
InputError point_outside_block(const std::string& place, const std::string& block);

}  // namespace talus
