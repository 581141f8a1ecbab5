#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "mesh/block.hpp"
#include "model/project.hpp"
#include "results/frame.hpp"

namespace talus {

/// A project that was cut, meshed and run: what pictures of results are drawn of.
struct SolvedScene {
  Project project;
  BlockSystem system;
  std::shared_ptr<const Frame> frame;  ///< the last one
};

/// Of each stage so many steps at most. `folder`: where the project's files lie.
SolvedScene solved(Project project, const std::filesystem::path& folder, int steps_a_stage);

/// A slab on a slope that has lost its strength, of blocks that are rigid, affine and meshed in turns; pressed, loaded,
/// anchored and watched. Solved once, for all pictures.
const SolvedScene& sliding_slab();

}  // namespace talus
