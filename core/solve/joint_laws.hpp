#pragma once

#include <vector>

#include "contact/contact_point.hpp"
#include "contact/pair_joints.hpp"

namespace talus {

struct BlockSystem;
struct Project;

/// Strength and stiffness of the project's joints as contact sees them, in Project::joints' order.
/// A project without joints gets one law without friction.
std::vector<JointLaw> joint_laws(const Project& project);

/// Where facets of two blocks lie on no common joint plane, the joint of the interface between the blocks holds, else
/// the project's default. Index into joint_laws.
PairJoints pair_joints(const Project& project, const BlockSystem& system);

}  // namespace talus
