#include "session/solid_file.hpp"

#include "model/solid_moves.hpp"

namespace talus {

Project with_solid(Project project, const std::filesystem::path& file, const std::filesystem::path& folder) {
  if (project.materials.empty())
    project.materials.push_back({.name = "rock", .density = 2600, .young = 25e9, .poisson = 0.24});
  Solid solid;
  solid.name = free_name(project, file.stem().string());
  solid.shape = FileShape{std::filesystem::absolute(file).lexically_relative(folder).generic_string()};
  solid.material = project.materials.front().name;
  project.solids.push_back(solid);
  return project;
}

}  // namespace talus
