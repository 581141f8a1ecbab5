#include "orientation/project_joints.hpp"

#include <algorithm>
#include <cmath>
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

namespace {

/// Parallel planes, so far apart, that meet a box, in place of the one plane of a cut.
void repeat_through(Cut& cut, double spacing, const BoxShape& box) {
  const Vec3 up = -pole_of({cut.dip, cut.dip_direction});
  const Vec3 middle = (box.min + box.max) / 2, half = (box.max - box.min) / 2;
  const double away = up.dot(middle - cut.through), reach = up.cwiseAbs().dot(half);
  constexpr double little = 1e-6;  // of a spacing: a plane in a face of the rock cuts nothing
  const double first = std::floor((away - reach) / spacing + little) + 1;
  const double last = std::ceil((away + reach) / spacing - little) - 1;
  if (last <= first) return;
  const double micrometres = 1e6;
  cut.through = ((cut.through + first * spacing * up) * micrometres).array().round() / micrometres;
  cut.spacing = spacing;
  cut.count = static_cast<int>(last - first) + 1;
}

}  // namespace

Project with_joints(Project project, std::span<const MeasuredJoint> joints, const Joint& strength, const Vec3& at,
                    const std::optional<BoxShape>& rock) {
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
    if (rock && measured.spacing) repeat_through(cut, *measured.spacing, *rock);
    project.cuts.push_back(cut);
  }
  // Contacts on no cut need a joint as soon as there are joints.
  if (project.default_joint.empty() && !project.joints.empty()) project.default_joint = project.joints.front().name;
  return project;
}

}  // namespace talus
