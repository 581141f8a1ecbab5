#include "jobs/solver_parts.hpp"

#include <memory>

#include "base/error.hpp"
#include "geometry/kept_meshes.hpp"
#include "model/rules/validate.hpp"
#include "run/run_estimate.hpp"

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

SolverParts solverParts() {
  const auto build = [kept = std::make_shared<KeptMeshes>()](const Project& project,
                                                             const std::filesystem::path& folder, Progress& progress) {
    return build_blocks(project, folder, progress, *kept);
  };
  const auto solve = [](const Project& project, const BlockSystem& system, const RunOptions& options,
                        RunObserver& observer) {
    require_room(run_estimate(project, system), options.out);
    return run(project, system, options, observer);
  };
  return {build, sizeWhereItCanRun, solve};
}

}  // namespace talus
