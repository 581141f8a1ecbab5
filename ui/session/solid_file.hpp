#pragma once

#include <filesystem>

#include "model/project.hpp"

namespace talus {

/// The project with one more solid, that of a file of geometry; with a rock where it has no material yet. The file is
/// named as it is seen from `folder`. What the format does not know of is told when the project is checked.
Project with_solid(Project project, const std::filesystem::path& file, const std::filesystem::path& folder);

}  // namespace talus
