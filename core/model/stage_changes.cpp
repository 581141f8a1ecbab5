#include "model/stage_changes.hpp"

#include <algorithm>

namespace talus {

namespace {

void change(Joint& joint, const JointChange& change) {
  if (change.friction_angle) joint.friction_angle = *change.friction_angle;
  if (change.residual_friction_angle) joint.residual_friction_angle = *change.residual_friction_angle;
  if (change.cohesion) joint.cohesion = *change.cohesion;
  if (change.tensile_strength) joint.tensile_strength = *change.tensile_strength;
}

/// Of the list under `key` that holds in a stage: the project's own, or that of the last stage that gives one.
template <class Gives>
Place place_of(const Project& project, int stage, const char* key, Gives gives) {
  for (int k = stage; k >= 0; --k)
    if (gives(project.stages[k])) return Place() / "stages" / static_cast<std::size_t>(k) / key;
  return Place() / key;
}

}  // namespace

Place place_of_loads(const Project& project, int stage) {
  return place_of(project, stage, "loads", [](const Stage& s) { return s.loads.has_value(); });
}

Place place_of_constraints(const Project& project, int stage) {
  return place_of(project, stage, "constraints", [](const Stage& s) { return s.constraints.has_value(); });
}

Project project_in_stage(const Project& project, int stage) {
  Project changed = project;
  for (int k = 0; k <= stage; ++k) {
    const Stage& s = project.stages[k];
    for (const JointChange& joint : s.joints)
      for (Joint& present : changed.joints)
        if (present.name == joint.name) change(present, joint);
    if (s.loads) changed.loads = *s.loads;
    if (s.constraints) changed.constraints = *s.constraints;
  }
  return changed;
}

std::vector<std::string> blocks_held_in_stage(const Project& project, int stage) {
  std::vector<std::string> held;
  for (int k = 0; k <= stage; ++k)
    for (const BlockChange& block : project.stages[k].blocks) {
      std::erase(held, block.name);
      if (block.body == BodyKind::fixed) held.push_back(block.name);
    }
  return held;
}

}  // namespace talus
