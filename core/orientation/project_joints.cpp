#include "orientation/project_joints.hpp"

#include <algorithm>
#include <iterator>

#include "orientation/drawn_planes.hpp"

namespace talus {

ProjectJoints joints_of(const Project& project, int most) {
  ProjectJoints found;
  for (std::size_t i = 0; i < project.cuts.size(); ++i) {
    Cut cut = project.cuts[i];
    if (is_drawn(cut) && cut.count.value_or(1) > most) {
      cut.count = most;
      found.complete = false;
    }
    std::vector<Cut> planes = is_drawn(cut) ? single_planes(cut) : std::vector{cut};
    if (std::ssize(planes) > most) {
      planes.resize(static_cast<std::size_t>(most));
      found.complete = false;
    }
    for (const Cut& plane : planes) {
      found.joints.push_back(
          {upright({plane.dip, plane.dip_direction}), cut.joint, plane.through, cut.spacing, std::nullopt});
      found.cuts.push_back(static_cast<int>(i));
    }
  }
  return found;
}

Project with_joints(Project project, std::span<const MeasuredJoint> joints, const Joint& strength, const Vec3& at) {
  for (const MeasuredJoint& measured : joints) {
    Joint joint = strength;
    if (!measured.set.empty()) joint.name = measured.set;
    if (std::ranges::find(project.joints, joint.name, &Joint::name) == project.joints.end())
      project.joints.push_back(joint);
    Cut cut;
    cut.joint = joint.name;
    cut.dip = measured.plane.dip;
    cut.dip_direction = measured.plane.dip_direction;
    cut.through = measured.at.value_or(at);
    cut.polygon = measured.corners;
    project.cuts.push_back(cut);
  }
  // Contacts on no cut need a joint as soon as there are joints.
  if (project.default_joint.empty() && !project.joints.empty()) project.default_joint = project.joints.front().name;
  return project;
}

}  // namespace talus
