#pragma once

#include <cmath>

#include "solve/simulation.hpp"
#include "support/small_scenes.hpp"

namespace talus::test {

/// A project of one rock and one joint J with these stages.
inline Project rock_project(double friction_angle, std::vector<Stage> stages) {
  Project project;
  project.name = "scene";
  project.materials = {{"rock", 2600, 5e9, 0.24}};
  project.joints = {{"J", friction_angle, 0, 0, {}, {}, {}, {}}};
  project.default_joint = "J";
  project.stages = std::move(stages);
  return project;
}

inline BlockSystem block_system(std::vector<Block> list) {
  BlockSystem system;
  system.blocks = std::move(list);
  system.joint_names = {"J"};
  system.solids_volume = 1;
  return system;
}

/// Gravity of a plane that dips by `dip` degrees towards +x, in the plane's own axes.
inline Vec3 tilted_gravity(double dip) {
  return 9.81 * Vec3(std::sin(dip * M_PI / 180), 0, -std::cos(dip * M_PI / 180));
}

/// A unit cube on a fixed slab.
inline BlockSystem cube_on_slab() {
  return block_system({box_block("ground", Vec3(-5, -5, -1), Vec3(20, 5, 0), BodyKind::fixed),
                       box_block("B", Vec3(0, 0, 0), Vec3(1, 1, 1))});
}

}  // namespace talus::test
