#include "jobs/solver_parts.hpp"

#include "base/error.hpp"
#include "model/rules/validate.hpp"

namespace talus {

namespace {

std::optional<SceneSize> sizeWhereItCanRun(const Project& project, const BlockSystem& system) {
  try {
    validate(project);
  } catch (const InputError&) {
    return std::nullopt;
  }
  return scene_size(project, system);
}

}  // namespace

SolverParts solverParts() { return {build_blocks, sizeWhereItCanRun, run}; }

}  // namespace talus
