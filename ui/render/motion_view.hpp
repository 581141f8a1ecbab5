#pragma once

#include "mesh/block.hpp"
#include "render/scene.hpp"
#include "results/frame.hpp"

namespace talus {

/// Points the scene's camera at what has moved by `last`: from before it, a little to the side, so that a slide comes
/// towards the eye and no slope hides it. The view iso where nothing has moved worth seeing.
void look_at_motion(Scene& scene, const BlockSystem& system, const Frame& last);

}  // namespace talus
