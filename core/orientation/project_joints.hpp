#pragma once

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "model/project.hpp"
#include "orientation/joint_table.hpp"

/// Joints of a project as measured ones, and back.
namespace talus {

/// The joints of a project, and the number of the cut that each belongs to.
struct ProjectJoints {
  std::vector<MeasuredJoint> joints;
  std::vector<int> cuts;
  bool complete = true;  ///< no cut has more joints than were asked for
};

/// One for every cut, in their order, and one for every joint of a cut that is drawn by chance; the set is the name of
/// its joint. Of each cut at most the first `most`.
ProjectJoints joints_of(const Project& project, int most = std::numeric_limits<int>::max());

/// The project with a cut for every joint, at the end of its list. Sets become joints; where the project has none of
/// that name, one is added with the values of `strength`. Joints without a set take the name of `strength`, those
/// without a place go through `at`. A joint with a spacing stays a single plane, as a survey says where each one is;
/// where the extent of the `rock` is given it becomes parallel planes that go through all of it, one of them where the
/// table has it. Where the project has no default joint, its first joint is.
Project with_joints(Project project, std::span<const MeasuredJoint> joints, const Joint& strength, const Vec3& at,
                    const std::optional<BoxShape>& rock = {});

}  // namespace talus
