#pragma once

#include <vector>

#include "contact/contact_point.hpp"

namespace talus {

struct BlockSystem;
struct Project;

/// Strength and stiffness of the project's joints as contact sees them, in Project::joints' order.
/// A project without joints gets one law without friction.
std::vector<JointLaw> joint_laws(const Project& project);

/// For every two blocks the joint that holds where their facets lie on no common joint plane: that of the interface
/// between them, else the project's default. Index into joint_laws.
std::vector<std::vector<int>> pair_joints(const Project& project, const BlockSystem& system);

}  // namespace talus
