#include "run/solver_steps.hpp"

namespace talus {

SolverSteps solverSteps() { return {build_blocks, run}; }

}  // namespace talus
