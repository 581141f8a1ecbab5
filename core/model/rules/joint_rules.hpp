#pragma once

#include "model/place.hpp"
#include "model/project.hpp"

namespace talus {

/// The rules of a joint's properties, at `place` in the project. Throws InputError for the first that is broken.
void check(const Joint& joint, const Place& place);

}  // namespace talus
