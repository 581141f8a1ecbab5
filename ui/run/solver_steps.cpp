#include "run/solver_steps.hpp"

namespace talus {

SolverSteps solverSteps() { return {build_blocks, scene_size, run}; }

}  // namespace talus
