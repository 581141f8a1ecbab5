#pragma once

#include "bodies/body_set.hpp"

namespace talus {

/// Where the nodes of all movable bodies get to in a time `length` [s] if each body goes on turning and flying as it
/// does now: its mean velocity and spin taken as a finite rotation, what its nodes do beside that as a straight line. 3
/// numbers a movable node [m].
void continue_motion(const BodySet& set, double length, Increment& d);

}  // namespace talus
