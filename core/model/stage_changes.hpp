#pragma once

#include "model/project.hpp"

namespace talus {

/// The project as it holds in a stage: the changes of this stage and of those before it made, in their order. Names
/// have been validated.
Project project_in_stage(const Project& project, int stage);

/// Names of the blocks that a stage (and those before it) holds fixed although they were built to move.
std::vector<std::string> blocks_held_in_stage(const Project& project, int stage);

}  // namespace talus
