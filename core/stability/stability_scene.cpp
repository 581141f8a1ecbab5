#include "stability/stability_scene.hpp"

#include <algorithm>
#include <stdexcept>

namespace talus {

int Course::block(const std::string& name) const {
  const auto found =
      std::find_if(system.blocks.begin(), system.blocks.end(), [&](const Block& one) { return one.name == name; });
  if (found == system.blocks.end()) throw std::logic_error("the scene has no block '" + name + "'");
  return static_cast<int>(found - system.blocks.begin());
}

const Moment& Course::end_of_stage(int stage) const {
  const auto last =
      std::find_if(moments.rbegin(), moments.rend(), [stage](const Moment& moment) { return moment.stage == stage; });
  if (last == moments.rend()) throw std::logic_error("the run did not come to stage " + std::to_string(stage));
  return *last;
}

std::vector<StabilityScene> with_nudges(const StabilityScene& scene, int times) {
  std::vector<StabilityScene> scenes(times + 1, scene);
  for (int i = 1; i <= times; ++i) {
    scenes[i].name += "+" + std::to_string(i);
    scenes[i].build = [build = scene.build, factor = 1 + 1e-10 * i] {
      CaseScene nudged = build();
      nudged.project.gravity *= factor;
      for (InitialVelocity& velocity : nudged.project.velocities) {
        velocity.linear *= factor;
        velocity.angular *= factor;
      }
      return nudged;
    };
  }
  return scenes;
}

}  // namespace talus
