#include "model/stages.hpp"
#include "verification/hard_cases/classic/classic_scenes.hpp"

namespace talus {

namespace {

constexpr double link_length = 1.4, link_width = 1, link_bar = 0.2;  // m, of a link

/// A flat ring upright in the plane y = 0, its upper end at z = 0.
TetMesh link() {
  return grid_mesh({-link_width / 2, -link_width / 2 + link_bar, link_width / 2 - link_bar, link_width / 2},
                   {-link_bar / 2, link_bar / 2}, {-link_length, -link_length + link_bar, -link_bar, 0},
                   [](int i, int, int k) { return i != 1 || k != 1; });
}

/// Every link hangs with its upper bar across the lower bar of the one above, face on face, a quarter turn apart.
HardCase chain(int links) {
  return {.name = "chain_" + std::to_string(links),
          .group = classic_group,
          .title = "Chain of " + std::to_string(links) + " links hangs",
          .source = "Ferguson et al. 2021 (rigid IPC)",
          .expected = {all_rest(0, 1e-6)},
          .build = [=] {
            CaseScene scene = scene_of(hard_stone(), 0.5);
            for (int i = 0; i < links; ++i)
              scene.add_block(
                  "link " + std::to_string(i + 1),
                  placed(link(), turn_about(Vec3::UnitZ(), i % 2 ? 90 : 0), {0, 0, -i * (link_length - 2 * link_bar)}),
                  i == 0 ? BodyKind::fixed : BodyKind::rigid);
            scene.project.stages = {static_stage(0.01, 100), dynamic_stage(2e-3, 2)};
            return scene;
          }};
}

/// Pushed by 2 m/s at its lower end it swings and jerks; no link comes off the one above.
HardCase swinging_chain(int links) {
  const std::string last = "link " + std::to_string(links);
  const double least = links * (link_length - 2 * link_bar);  // m: the last centroid is never farther below the top
  return {.name = "chain_" + std::to_string(links) + "_swings",
          .group = classic_group,
          .title = "Chain of " + std::to_string(links) + " links, struck at its end",
          .expected = {stays_before({0, 0, -least}, Vec3::UnitZ())},
          .build = [=] {
            CaseScene scene = chain(links).build();
            scene.project.stages = {dynamic_stage(1e-3, 2)};
            scene.project.velocities = {{.block = last, .linear = {2, 1, 0}}};
            return scene;
          }};
}

}  // namespace

std::vector<HardCase> chain_scenes() { return {chain(3), chain(5), chain(10), swinging_chain(5)}; }

}  // namespace talus
