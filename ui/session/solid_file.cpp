#include "session/solid_file.hpp"

#include <algorithm>

namespace talus {

namespace {

bool isTaken(const Project& project, const std::string& name) {
  const auto called = [&](const auto& thing) { return thing.name == name; };
  return std::any_of(project.solids.begin(), project.solids.end(), called) ||
         std::any_of(project.blocks.begin(), project.blocks.end(), called);
}

}  // namespace

Project with_solid(Project project, const std::filesystem::path& file, const std::filesystem::path& folder) {
  if (project.materials.empty())
    project.materials.push_back({.name = "rock", .density = 2600, .young = 25e9, .poisson = 0.24});
  Solid solid;
  solid.name = file.stem().string();
  for (int number = 2; isTaken(project, solid.name); ++number)
    solid.name = file.stem().string() + ' ' + std::to_string(number);
  solid.shape = FileShape{std::filesystem::absolute(file).lexically_relative(folder).generic_string()};
  solid.material = project.materials.front().name;
  project.solids.push_back(solid);
  return project;
}

}  // namespace talus
