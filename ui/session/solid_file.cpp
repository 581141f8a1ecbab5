#include "session/solid_file.hpp"

#include "model/solid_moves.hpp"
#include "model/solid_shape.hpp"

namespace talus {

Project with_rock(Project project) {
  if (project.materials.empty())
    project.materials.push_back({.name = "rock", .density = 2600, .young = 25e9, .poisson = 0.24});
  return project;
}

Project with_solid(Project project, Solid solid, const std::filesystem::path& file,
                   const std::filesystem::path& folder) {
  project = with_rock(std::move(project));
  solid.name = free_name(project, solid.name.empty() ? file.stem().string() : solid.name);
  *file_of(solid.shape) = std::filesystem::absolute(file).lexically_relative(folder).generic_string();
  solid.material = project.materials.front().name;
  project.solids.push_back(solid);
  return project;
}

}  // namespace talus
