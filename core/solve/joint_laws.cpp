#include "solve/joint_laws.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/units.hpp"
#include "mesh/block.hpp"

namespace talus {

namespace {

int joint_index(const Project& project, const std::string& name) {
  const auto found =
      std::find_if(project.joints.begin(), project.joints.end(), [&](const Joint& j) { return j.name == name; });
  return found == project.joints.end() ? 0 : static_cast<int>(found - project.joints.begin());
}

}  // namespace

std::vector<JointLaw> joint_laws(const Project& project) {
  std::vector<JointLaw> laws;
  for (const Joint& joint : project.joints) {
    JointLaw law;
    law.friction = std::tan(radians(joint.friction_angle));
    law.residual_friction = std::tan(radians(joint.residual_friction_angle.value_or(joint.friction_angle)));
    law.cohesion = joint.cohesion;
    law.tensile_strength = joint.tensile_strength;
    law.normal_stiffness = joint.normal_stiffness.value_or(0);
    law.shear_stiffness = joint.shear_stiffness.value_or(0);
    if (project.solver.effects.restitution != Switch::off) law.restitution = joint.restitution;
    laws.push_back(law);
  }
  if (laws.empty()) laws.emplace_back();
  return laws;
}

PairJoints pair_joints(const Project& project, const BlockSystem& system) {
  std::map<std::string, int> number;
  for (std::size_t b = 0; b < system.blocks.size(); ++b) number.emplace(system.blocks[b].name, static_cast<int>(b));
  PairJoints pairs(joint_index(project, project.default_joint));
  for (const Interface& interface : project.interfaces) {
    const auto a = number.find(interface.between[0]), b = number.find(interface.between[1]);
    if (a != number.end() && b != number.end()) pairs.set(a->second, b->second, joint_index(project, interface.joint));
  }
  return pairs;
}

}  // namespace talus
