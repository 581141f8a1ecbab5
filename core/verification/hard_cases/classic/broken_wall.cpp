#include "model/stages.hpp"
#include "verification/hard_cases/classic/classic_scenes.hpp"
#include "verification/hard_cases/voronoi.hpp"

namespace talus {

namespace {

/// 100 Voronoi pieces of a wall 4 × 0.4 × 3 m, and a cube of a tenth of their mass at 120 m/s. Where blows give nothing
/// back it goes on: if it took the whole wall along, at 11.6 m/s.
HardCase broken_wall(const std::string& name, const std::string& how, std::optional<double> restitution,
                     std::vector<HardCaseExpectation> expected) {
  return {.name = name,
          .group = classic_group,
          .title = "Wall of 100 Voronoi pieces hit at 120 m/s, " + how,
          .source = "Ferguson et al. 2021 (rigid IPC)",
          .expected = std::move(expected),
          .build = [=] {
            CaseScene scene = scene_of(hard_stone(), 0.5);
            scene.project.joints[0].restitution = restitution;
            scene.add_fixed_box("floor", {-10, -6, -1}, {10, 30, 0});
            int number = 0;
            for (TetMesh& piece : voronoi_pieces({-2, 0, 0}, {2, 0.4, 3}, 100, 5))
              scene.add_block("piece " + std::to_string(++number), std::move(piece), BodyKind::rigid);
            scene.add_block("cube", placed(cube(0.8), {0, -0.6, 1.5}), BodyKind::rigid);
            scene.project.velocities = {{.block = "cube", .linear = {0, 120, 0}}};
            scene.project.stages = {dynamic_stage(2e-4, 0.1)};
            return scene;
          }};
}

}  // namespace

std::vector<HardCase> broken_wall_scenes() {
  const auto above_the_floor = stays_before(Vec3::Zero(), Vec3::UnitZ());
  const auto through_the_wall = travels_at_least("cube", Vec3::UnitY(), 1.1);
  return {broken_wall("broken_wall", "no restitution given", std::nullopt, {above_the_floor, through_the_wall}),
          broken_wall("broken_wall_plastic", "blows give nothing back", 0, {above_the_floor, through_the_wall}),
          broken_wall("broken_wall_elastic", "blows take nothing", 1, {above_the_floor})};
}

}  // namespace talus
