#include <algorithm>
#include <cmath>

#include "base/units.hpp"
#include "model/number_text.hpp"
#include "model/stages.hpp"
#include "verification/hard_cases/classic/classic_scenes.hpp"

namespace talus {

namespace {

/// Ten metres a step, through a plane two metres thick if nobody looks in between.
HardCase bullet() {
  return {.name = "plane_at_1000",
          .group = classic_group,
          .title = "Cube at 1000 m/s hits a plane, step 10 ms",
          .source = "Li et al. 2020 (IPC)",
          .expected = {stays_before({0, 0, 0}, Vec3::UnitZ())},
          .build = [] {
            CaseScene scene = scene_of(hard_stone(), 0.5);
            scene.add_fixed_box("plane", {-20, -20, -2}, {20, 20, 0});
            scene.add_block("cube", placed(cube(1), {0, 0, 25.7}), BodyKind::tetrahedra);
            scene.project.velocities = {{.block = "cube", .linear = {0, 0, -1000}}};
            scene.project.stages = {dynamic_stage(0.01, 0.2)};
            return scene;
          }};
}

/// Once turned over, a box that spins about its middle axis is a half turn away from where it began whatever its spin
/// has come to, for as long as it stays so: some turns. Before, its rotation passes through zero in every turn.
HardCaseExpectation turns_over(double turn) {
  return {"the box turns over", [=](const Trajectory& trajectory) -> std::string {
            double since = 0, longest = 0;
            for (const Snapshot& snapshot : trajectory.snapshots) {
              if (snapshot.blocks[0].rotation < radians(150)) since = snapshot.time;
              longest = std::max(longest, snapshot.time - since);
            }
            return longest > turn ? "" : "for " + decimals(longest, 2) + " s at most it is turned over";
          }};
}

/// A disturbance of 1e-2 grows at ω√((I₂−I₃)(I₁−I₂)/I₁I₃) = 1.5 per s: the box turns over within some 5 s.
HardCase dzhanibekov() {
  return {.name = "dzhanibekov",
          .group = classic_group,
          .title = "Box spins about its middle axis at 180°/s and turns over",
          .source = "Ferguson et al. 2021 (rigid IPC)",
          .expected = {turns_over(2), rests("box", -1, 1e-9, 181)},
          .build = [] {
            CaseScene scene = scene_of(hard_stone(), 0);
            scene.project.gravity.setZero();
            scene.add_block("box", box_mesh({-0.5, -1, -1.5}, {0.5, 1, 1.5}, 1, 1, 1), BodyKind::rigid);
            scene.project.velocities = {{.block = "box", .angular = {0.01, radians(180), 0.01}}};
            scene.project.stages = {dynamic_stage(0.01, 12)};
            return scene;
          }};
}

}  // namespace

std::vector<HardCase> fast_scenes() { return {bullet(), dzhanibekov()}; }

}  // namespace talus
