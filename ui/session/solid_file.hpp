#pragma once

#include <filesystem>

#include "model/project.hpp"

namespace talus {

/// The project with a material, a rock of usual properties where it has none yet.
Project with_rock(Project project);

/// The project with one more solid, whose shape is read from `file`; with a rock where it has no material yet. The file
/// is named as it is seen from `folder`; a solid without a name is called after it. What the format does not know of is
/// told when the project is checked.
Project with_solid(Project project, Solid solid, const std::filesystem::path& file,
                   const std::filesystem::path& folder);

}  // namespace talus
