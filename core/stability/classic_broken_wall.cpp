#include "cases/block_scene.hpp"
#include "stability/classic_parts.hpp"
#include "stability/voronoi.hpp"

namespace talus {

namespace {

/// 100 Voronoi pieces of a wall 4 × 0.4 × 3 m, and a cube of a tenth of their mass at 120 m/s. Where blows give nothing
/// back it goes on: if it took the whole wall along, at 11.6 m/s. At a restitution of 1 contact springs and the time
/// step decide whether it is thrown back.
StabilityScene broken_wall(const std::string& name, const std::string& how, double restitution,
                           const std::string& shortfall) {
  return {.name = name,
          .group = classic_group,
          .title = "Wall of 100 Voronoi pieces hit at 120 m/s, " + how,
          .source = "Ferguson et al. 2021 (rigid IPC)",
          .shortfall = shortfall,
          .expected = {stays_before(Vec3::Zero(), Vec3::UnitZ()), travels_at_least("cube", Vec3::UnitY(), 1.1)},
          .build = [=] {
            CaseScene scene = scene_of(hard_stone(), 0.5);
            scene.project.joints[0].restitution = restitution;
            add_fixed_box(scene, "floor", {-10, -6, -1}, {10, 30, 0});
            int number = 0;
            for (TetMesh& piece : voronoi_pieces({-2, 0, 0}, {2, 0.4, 3}, 100, 5))
              scene.add_block("piece " + std::to_string(++number), std::move(piece), BodyKind::rigid);
            scene.add_block("cube", placed(cube(0.8), {0, -0.6, 1.5}), BodyKind::rigid);
            scene.project.velocities = {{.block = "cube", .linear = {0, 120, 0}}};
            scene.project.stages = {motion(2e-4, 0.1)};
            return scene;
          }};
}

}  // namespace

std::vector<StabilityScene> broken_wall_scenes() {
  return {broken_wall("broken_wall", "blows take nothing", 1,
                      "the cube is thrown back: how much of a blow is given back depends on where in a step it falls"),
          broken_wall("broken_wall_plastic", "blows give nothing back", 0, "")};
}

}  // namespace talus
