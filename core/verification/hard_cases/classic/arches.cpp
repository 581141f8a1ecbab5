#include "model/number_text.hpp"
#include "model/stages.hpp"
#include "verification/hard_cases/classic/classic_scenes.hpp"
#include "verification/known_answers/blocks/voussoirs.hpp"

namespace talus {

namespace {

constexpr double arch_radius = 10, arch_depth = 2, thickness = 0.2;  // m, m, of the radius

/// On a floor, whose friction takes the thrust.
CaseScene masonry(int stones, double friction, double duration) {
  CaseScene scene = scene_of({.name = "stone", .density = 2300, .young = 2e10, .poisson = 0.2}, friction);
  scene.add_fixed_box("floor", {-40, -3, -1}, {40, 3, 0});
  for (int i = 0; i < stones; ++i) {
    const auto stone = voussoir({stones, thickness}, i, arch_radius, arch_depth);
    scene.add_block("stone " + std::to_string(i + 1), hexahedron_mesh(stone, 1, 1, 1), BodyKind::rigid);
  }
  scene.project.stages = {static_stage(0.01, 100), dynamic_stage(0.01, duration)};
  return scene;
}

/// Whether it stands is what limit analysis says: a thrust line within the joints and their friction.
HardCase arch(int stones, double friction) {
  const bool does = stands({stones, thickness}, friction);
  const double duration = does ? 20 : 3;  // s
  const std::string crown = "stone " + std::to_string(stones / 2 + 1);
  return {.name = "arch_" + std::to_string(stones) + (does ? "" : "_slippery"),
          .group = classic_group,
          .title = "Arch of " + std::to_string(stones) + " stones, span 20 m, μ " + decimals(friction, 1) +
                   (does ? " stands" : " falls"),
          .source = "Ferguson et al. 2021 (rigid IPC); limit analysis",
          .takes_long = stones > 101,
          .expected = {does ? all_rest(0, 1e-6) : travels_at_least(crown, -Vec3::UnitZ(), 2),
                       stays_before(Vec3::Zero(), Vec3::UnitZ())},
          .build = [=] { return masonry(stones, friction, duration); }};
}

}  // namespace

std::vector<HardCase> arch_scenes() { return {arch(25, 0.5), arch(101, 0.5), arch(501, 0.5), arch(25, 0.2)}; }

}  // namespace talus
