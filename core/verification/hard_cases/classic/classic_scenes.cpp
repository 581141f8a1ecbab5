#include <cmath>
#include <iterator>

#include "base/units.hpp"
#include "verification/hard_cases/classic/classic_scenes.hpp"

namespace talus {

Joint joint_of(const std::string& name, double friction) {
  Joint joint;
  joint.name = name;
  joint.friction_angle = degrees(std::atan(friction));
  return joint;
}

CaseScene scene_of(const Material& material, double friction) {
  CaseScene scene;
  scene.project.name = material.name;
  scene.add_material(material);
  scene.add_joint(joint_of("joint", friction));
  return scene;
}

Material hard_stone() { return {.name = "stone", .density = 2600, .young = 50e9, .poisson = 0.24}; }

std::vector<HardCase> classic_scenes() {
  std::vector<HardCase> all;
  for (const auto& kind : {erleben_scenes, friction_scenes, tight_fit_scenes, stack_scenes, arch_scenes,
                           card_house_scenes, chain_scenes, fast_scenes, broken_wall_scenes}) {
    std::vector<HardCase> scenes = kind();
    std::move(scenes.begin(), scenes.end(), std::back_inserter(all));
  }
  return all;
}

}  // namespace talus
