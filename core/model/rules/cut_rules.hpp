#pragma once

#include "model/place.hpp"
#include "model/project.hpp"

namespace talus {

/// The rules of a cut, at `place` in the project. Throws InputError for the first that is broken.
void check(const Cut& cut, const Place& place);

}  // namespace talus
