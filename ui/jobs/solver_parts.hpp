#pragma once

#include <functional>
#include <optional>

#include "geometry/block_builder.hpp"
#include "run/effect_costs.hpp"
#include "run/run.hpp"

namespace talus {

/// The parts of the work of a job; tests put shorter ones in their place.
struct SolverParts {
  std::function<BlockSystem(const Project&, const std::filesystem::path& folder, Progress&)> mesh;
  /// Nothing for a project that is still being set up.
  std::function<std::optional<SceneSize>(const Project&, const BlockSystem&)> size;
  std::function<RunReport(const Project&, const BlockSystem&, const RunOptions&, RunObserver&)> solve;
};

/// build_blocks, which keeps meshes from one time to the next, scene_size and run.
SolverParts solverParts();

}  // namespace talus
