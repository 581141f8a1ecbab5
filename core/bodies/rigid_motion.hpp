#pragma once

#include "bodies/body_set.hpp"

namespace talus {

/// Where the nodes of all movable bodies get to in a time `length` [s] if each body goes on turning and flying as it
/// does now: its mean velocity and spin taken as a finite rotation, what its nodes do beside that as a straight line. 3
/// numbers a movable node [m].
void continue_motion(const BodySet& set, double length, Increment& d);

/// Bends `to`, which is `from` and a further `change` along straight lines, 3 numbers a node of a body that deforms
/// [m]: the rotation that is nearest to the change is taken as a finite one, for it would stretch the body by half its
/// square.
void turn_on(const BodySet& set, const Body& body, const Increment& from, const Eigen::VectorXd& change, Increment& to);

}  // namespace talus
