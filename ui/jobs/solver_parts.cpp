#include "jobs/solver_parts.hpp"

#include <memory>

#include "base/error.hpp"
#include "geometry/kept_meshes.hpp"
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

SolverParts solverParts() {
  const auto build = [kept = std::make_shared<KeptMeshes>()](const Project& project,
                                                             const std::filesystem::path& folder, Progress& progress) {
    return build_blocks(project, folder, progress, *kept);
  };
  return {build, sizeWhereItCanRun, run};
}

}  // namespace talus
