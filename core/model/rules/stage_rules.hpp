#pragma once

#include "model/project.hpp"

namespace talus {

/// The rules of the stages: how long they are, and what they may change. That the joints and blocks they name exist is
/// for `validate_references`. Throws InputError for the first rule that is broken.
void check_stages(const Project& project);

}  // namespace talus
