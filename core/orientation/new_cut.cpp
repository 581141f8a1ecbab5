#include "orientation/new_cut.hpp"

#include <algorithm>
#include <cmath>

namespace talus {
namespace {

constexpr double usual_friction = 30;  // degrees

const std::string& joint_for_cut(Project& project, const std::string& wanted) {
  if (!wanted.empty()) return wanted;
  if (!project.default_joint.empty()) return project.default_joint;
  if (project.joints.empty()) {
    project.joints.push_back({.name = "joint 1",
                              .friction_angle = usual_friction,
                              .residual_friction_angle = {},
                              .normal_stiffness = {},
                              .shear_stiffness = {},
                              .restitution = {}});
    project.default_joint = project.joints.front().name;
  }
  return project.joints.front().name;
}

double to_hundredths(double angle) { return std::round(angle * 100) / 100; }

}  // namespace

Project with_cut(Project project, const PlaneAttitude& plane, const Vec3& through, const std::string& joint) {
  Cut cut;
  cut.joint = joint_for_cut(project, joint);
  const PlaneAttitude attitude = upright({to_hundredths(plane.dip), to_hundredths(plane.dip_direction)});
  cut.dip = attitude.dip;
  cut.dip_direction = attitude.dip_direction;
  cut.through = (through * 1e3).array().round() * 1e-3;
  project.cuts.push_back(cut);
  return project;
}

Project with_interface(Project project, const std::string& one, const std::string& two, const std::string& joint) {
  std::erase_if(project.interfaces, [&](const Interface& known) {
    return (known.between[0] == one && known.between[1] == two) || (known.between[0] == two && known.between[1] == one);
  });
  project.interfaces.push_back({{one, two}, joint});
  return project;
}

}  // namespace talus
