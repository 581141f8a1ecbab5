#pragma once

#include "bodies/body_set.hpp"

namespace talus {

/// Gives the project's initial velocities to the nodes of their blocks: linear, and angular about the centroid.
void give_initial_velocities(const Project& project, const BlockSystem& system, BodySet& bodies);

}  // namespace talus
