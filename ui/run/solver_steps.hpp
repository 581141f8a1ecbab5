#pragma once

#include <functional>

#include "geometry/block_builder.hpp"
#include "solve/run.hpp"

namespace talus {

/// The two long pieces of work of a job; tests put shorter ones in their place.
struct SolverSteps {
  std::function<BlockSystem(const Project&, const std::filesystem::path& folder, Progress&)> mesh;
  std::function<RunReport(const Project&, const BlockSystem&, const RunOptions&, RunObserver&)> solve;
};

/// build_blocks and run.
SolverSteps solverSteps();

}  // namespace talus
