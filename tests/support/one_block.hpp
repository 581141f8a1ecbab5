#pragma once

#include "bodies/body_set.hpp"
#include "support/small_scenes.hpp"

namespace talus::test {

/// A box of 1 × 2 × 0.5 m that stands at (1, 2, 3).
inline BodySet one_block(BodyKind body) {
  Project project;
  project.materials = {{"rock", 2600, 5e9, 0.24}};
  BlockSystem system;
  system.blocks = {box_block("block", Vec3(1, 2, 3), Vec3(2, 4, 3.5), body)};
  return BodySet(project, system);
}

}  // namespace talus::test
