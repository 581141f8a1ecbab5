#include "jobs/solver_parts.hpp"

namespace talus {

SolverParts solverParts() { return {build_blocks, scene_size, run}; }

}  // namespace talus
