#pragma once

#include "model/place.hpp"
#include "model/project.hpp"

namespace talus {

/// The rules of what a project says of the blocks that cutting leaves, at `place` in the project. Each throws
/// InputError for the first that is broken.
void check(const BlockOverride& block, const Place& place);
void check(const Merge& merge, const Place& place);
void check(const Splinters& splinters, const Place& place);
void check(const MeshSettings& mesh, const Place& place);

}  // namespace talus
