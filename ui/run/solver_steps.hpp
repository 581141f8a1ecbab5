#pragma once

#include <functional>

#include "geometry/block_builder.hpp"
#include "solve/effect_costs.hpp"
#include "solve/run.hpp"

namespace talus {

/// The pieces of work of a job; tests put shorter ones in their place.
struct SolverSteps {
  std::function<BlockSystem(const Project&, const std::filesystem::path& folder, Progress&)> mesh;
  std::function<SceneSize(const Project&, const BlockSystem&)> size;
  std::function<RunReport(const Project&, const BlockSystem&, const RunOptions&, RunObserver&)> solve;
};

/// build_blocks, scene_size and run.
SolverSteps solverSteps();

}  // namespace talus
