#include <algorithm>
#include <cmath>

#include "base/units.hpp"
#include "mesh/moments.hpp"
#include "model/number_text.hpp"
#include "model/stages.hpp"
#include "verification/hard_cases/expectations.hpp"
#include "verification/hard_cases/scenes/scene_groups.hpp"
#include "verification/hard_cases/shapes.hpp"

// Steps from a millionth of a second to a second, and a hundred thousand of them.
namespace talus {

namespace {

const char* const time_group = "time";
constexpr double time_gravity = 9.81;  // m/s²

constexpr double slope_dip = 30, slope_friction_angle = 20;              // degrees
constexpr double drop_height = 5e-3, drop_speed = 1, drop_duration = 2;  // m, m/s, s

/// A flat block that comes down on an incline already moving along it. However it lands, friction is μ times what
/// presses: with the normal impulse, which is known from the fall, the distance is v t + g(sin α − μ cos α) t²/2 + μ h.
/// The same holds for the sums over steps of any length. What it still bounces at the end is a share of μ h, 3e-4 of
/// all.
HardCase fall_and_slide(int power) {
  const double friction = std::tan(radians(slope_friction_angle));
  const double along = time_gravity * (std::sin(radians(slope_dip)) - friction * std::cos(radians(slope_dip)));
  const double distance =
      drop_speed * drop_duration + along * drop_duration * drop_duration / 2 + friction * drop_height;
  const std::string step = power == 0 ? "1" : "1e-" + std::to_string(power);
  return {.name = "step_1e_minus_" + std::to_string(power),
          .group = time_group,
          .title = "Block falls on 30° and slides on, steps of " + step + " s",
          .takes_long = power > 5,
          .expected = {travels("block", Vec3::UnitX(), distance, 1e-3), stays_before(Vec3::Zero(), Vec3::UnitZ())},
          .build = [=] {
            CaseScene scene = rock_scene(slope_friction_angle);
            tilt(scene, slope_dip);
            scene.add_fixed_box("slab", {-2, -2, -1}, {10, 2, 0});
            scene.add_block("block", box_mesh({-0.5, -0.5, drop_height}, {0.5, 0.5, drop_height + 0.25}, 1, 1, 1),
                            BodyKind::rigid);
            scene.project.velocities = {{.block = "block", .linear = {drop_speed, 0, 0}}};
            scene.project.stages = {dynamic_stage(std::pow(10.0, -power), drop_duration)};
            return scene;
          }};
}

constexpr double short_step = 1e-3, long_time = 100;  // s: 1e5 steps

/// It yields elastically in the first second, and then not any more.
HardCase long_rest(BodyKind body) {
  const std::string kind(to_string(body));
  return {.name = "hundred_thousand_steps_rest_" + kind,
          .group = time_group,
          .title = "1e5 steps of a block of " + kind + " at rest on 20°, awake",
          .expected = {rests("block", 0, 1e-6), rests("block", 1, 1e-9)},
          .build = [=] {
            CaseScene scene = rock_scene(30);
            tilt(scene, 20);
            scene.add_fixed_box("slab", {-3, -3, -1}, {3, 3, 0});
            scene.add_block("block", box_mesh({-0.5, -0.5, 0}, {0.5, 0.5, 1}, 1, 1, 1), body);
            scene.project.solver.sleep_tolerance = 0;
            scene.project.stages = {static_stage(0.01, 20), dynamic_stage(short_step, 1),
                                    dynamic_stage(short_step, long_time)};
            return scene;
          }};
}

/// On a floor with inner edges in every metre it keeps its 1 m/s; on an incline a tenth of a degree too steep for its
/// friction it gains 0.018 m/s².
HardCase long_slide(bool is_rough) {
  const double slope = is_rough ? slope_friction_angle + 0.1 : 0;
  const double gain = time_gravity * std::sin(radians(0.1)) / std::cos(radians(slope_friction_angle));
  const double distance = is_rough ? gain * long_time * long_time / 2 : drop_speed * long_time;
  return {.name = std::string("hundred_thousand_steps_slide") + (is_rough ? "_rough" : "_smooth"),
          .group = time_group,
          .title = is_rough ? "1e5 steps of sliding, 0.1° steeper than friction" : "1e5 steps of frictionless sliding",
          .expected = {travels("block", Vec3::UnitX(), distance, is_rough ? 1e-3 : 1e-6)},
          .build = [=] {
            CaseScene scene = rock_scene(is_rough ? slope_friction_angle : 0);
            tilt(scene, slope);
            scene.add_block("slab", box_mesh({-2, -2, -1}, {108, 2, 0}, 110, 4, 1), BodyKind::fixed);
            scene.add_block("block", box_mesh({-0.5, -0.47, 0}, {0.5, 0.53, 0.25}, 1, 1, 1), BodyKind::rigid);
            if (!is_rough) scene.project.velocities = {{.block = "block", .linear = {drop_speed, 0, 0}}};
            scene.project.stages = {dynamic_stage(short_step, long_time)};
            return scene;
          }};
}

/// The block's centroid is never behind the plate's along `direction` of the blow.
HardCaseExpectation stays_in_front(const std::string& block, const std::string& plate, const Vec3& direction) {
  return {block + " does not pass through " + plate, [=](const Trajectory& trajectory) -> std::string {
            const int b = trajectory.block(block), p = trajectory.block(plate);
            const auto centroid = [&](int k) { return volume_moments(trajectory.system.blocks[k].mesh).centroid; };
            const Vec3 apart = centroid(p) - centroid(b);
            for (const Snapshot& snapshot : trajectory.snapshots) {
              const Vec3 moved = snapshot.blocks[p].displacement - snapshot.blocks[b].displacement;
              if (!((apart + moved).dot(direction) > 0))
                return "it is behind it at " + significant(snapshot.time) + " s";
            }
            return {};
          }};
}

/// In one step the cube would go through ten plates. Held, the plate is fixed; free, it is elastic and flies off.
HardCase plate_at_100(bool is_free) {
  constexpr double thickness = 0.02, side = 0.2, velocity = 100, coarse = 2e-3;  // m, m, m/s, s
  return {
      .name = std::string("plate_at_100_") + (is_free ? "free" : "fixed"),
      .group = time_group,
      .title = std::string("Cube at 100 m/s hits a ") + (is_free ? "free" : "fixed") + " plate of 2 cm, 20 cm a step",
      .expected = {stays_in_front("cube", "plate", -Vec3::UnitZ())},
      .build = [=] {
        CaseScene scene = rock_scene(30);
        scene.add_block("plate", box_mesh({-1, -1, -thickness}, {1, 1, 0}, 8, 8, 1),
                        is_free ? BodyKind::tetrahedra : BodyKind::fixed);
        scene.add_block("cube", placed(cube(side), {0.1, 0.05, 1.03}), BodyKind::rigid);
        scene.project.gravity.setZero();
        scene.project.velocities = {{.block = "cube", .linear = {0, 0, -velocity}}};
        scene.project.stages = {dynamic_stage(coarse, 0.1)};
        return scene;
      }};
}

}  // namespace

std::vector<HardCase> time_scenes() {
  std::vector<HardCase> scenes;
  for (int power = 6; power >= 0; --power) scenes.push_back(fall_and_slide(power));
  for (const BodyKind body : {BodyKind::rigid, BodyKind::tetrahedra}) scenes.push_back(long_rest(body));
  for (const bool is_rough : {false, true}) scenes.push_back(long_slide(is_rough));
  for (const bool is_free : {false, true}) scenes.push_back(plate_at_100(is_free));
  return scenes;
}

}  // namespace talus
