#pragma once

#include "render/scene/scene.hpp"
#include "results/frame.hpp"

namespace talus {

struct BlockSystem;

/// Points the scene's camera at the slope from before it, a little to the side, so that a slide comes towards the eye
/// and nothing hides it: before where the blocks have moved to by `last`, or, where there is no frame or nothing has
/// moved worth seeing, before where the ground looks down to. The view iso where the ground is level.
void look_at_slope(Scene& scene, const BlockSystem& system, const Frame* last);

}  // namespace talus
