#pragma once

#include "model/place.hpp"
#include "model/project.hpp"

namespace talus {

/// The project as it holds in a stage: the changes of this stage and of those before it made, in their order. Names
/// have been validated.
Project project_in_stage(const Project& project, int stage);

/// Where the loads and the constraints of a stage stand in the project: "/loads", or "/stages/1/loads" of the stage
/// that gave them last.
Place place_of_loads(const Project& project, int stage);
Place place_of_constraints(const Project& project, int stage);

/// Names of the blocks that a stage (and those before it) holds fixed although they were built to move.
std::vector<std::string> blocks_held_in_stage(const Project& project, int stage);

}  // namespace talus
