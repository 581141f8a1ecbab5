#pragma once

#include <string>
#include <vector>

#include "model/project.hpp"

namespace talus {

/// Checks the rules that the file's schema does not hold: ranges, names that must be unique or must exist, closed
/// polyhedra. Throws InputError for the first broken rule, with a JSON pointer as place.
void validate(const Project& project);

/// The same of a project that is still being set up: it may lack solids, stages and the default joint.
void validate_what_is_there(const Project& project);

/// What is needed to cut and mesh: the same, with solids.
void validate_for_cutting(const Project& project);

/// A block as geometry made it.
struct BuiltBlock {
  std::string name;
  BodyKind body = BodyKind::tetrahedra;
  bool chosen = false;  ///< the project left the choice of its body open: 'auto'
};

/// Checks every reference to a block once geometry has named the blocks, and what is asked of their bodies. Throws
/// InputError like `validate`.
void validate_against_blocks(const Project& project, const std::vector<BuiltBlock>& blocks);

}  // namespace talus
