#pragma once

#include <functional>

#include "geometry/block_builder.hpp"
#include "run/effect_costs.hpp"
#include "run/run.hpp"

namespace talus {

/// The parts of the work of a job; tests put shorter ones in their place.
struct SolverParts {
  std::function<BlockSystem(const Project&, const std::filesystem::path& folder, Progress&)> mesh;
  std::function<SceneSize(const Project&, const BlockSystem&)> size;
  std::function<RunReport(const Project&, const BlockSystem&, const RunOptions&, RunObserver&)> solve;
};

/// build_blocks, scene_size and run.
SolverParts solverParts();

}  // namespace talus
