#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/units.hpp"
#include "model/number_text.hpp"
#include "model/stages.hpp"
#include "verification/hard_cases/classic/classic_scenes.hpp"

namespace talus {

namespace {

/// 1 on 2 with μ 0.49 slides at g cos α (tan α − μ); with 0.50 friction just holds, if all of it points uphill. A cube
/// of elastic rock spreads under its weight, against some of the friction, until it has slipped and all of it does. A
/// gain of 1e-4 m/s in 4 s is 6e-6 of the drive.
HardCase incline(double friction) {
  const double slope = 0.5, dip = std::atan(slope), seconds = 5;
  const double acceleration = 9.81 * std::cos(dip) * (slope - friction);
  return {.name = "incline_" + std::to_string(static_cast<int>(std::lround(100 * friction))),
          .group = classic_group,
          .title = "Cube on an incline of 1 on 2, μ " + decimals(friction, 2),
          .source = "Li et al. 2020 (IPC)",
          .expected = friction < slope
                          ? std::vector{travels("cube", Vec3::UnitX(), acceleration * seconds * seconds / 2, 0.02)}
                          : std::vector{rests("cube", 0, 1e-6), gains_no_speed("cube", 1, 1e-4)},
          .build = [=] {
            CaseScene scene = scene_of({.name = "block", .density = 1000, .young = 1e9, .poisson = 0.4}, friction);
            tilt(scene, degrees(dip));
            scene.add_fixed_box("incline", {-2, -2, -1}, {4, 2, 0});
            scene.add_box("cube", {-0.5, -0.5, 0}, {0.5, 0.5, 1});
            scene.project.stages = {static_stage(0.025, 10), dynamic_stage(0.025, seconds)};
            if (friction < slope) scene.project.stages.erase(scene.project.stages.begin());  // it would creep
            return scene;
          }};
}

HardCase stop() {
  const double speed = 10, friction = 0.05, displacement = speed * speed / (2 * friction * 9.81);
  return {.name = "stop_from_10",
          .group = classic_group,
          .title = "Cube at 10 m/s stops by friction of 0.05",
          .source = "v²/2μg; Li et al. 2020 (IPC)",
          .expected = {travels("cube", Vec3::UnitX(), displacement, 0.01), stops("cube", 1e-6)},
          .build = [=] {
            CaseScene scene = scene_of(hard_stone(), friction);
            scene.add_fixed_box("plane", {-2, -2, -1}, {106, 2, 0});
            scene.add_box("cube", {-0.5, -0.5, 0}, {0.5, 0.5, 1});
            scene.project.velocities = {{.block = "cube", .linear = {speed, 0, 0}}};
            scene.project.stages = {dynamic_stage(0.01, 22)};
            return scene;
          }};
}

constexpr double disc_radius = 1, spin = 2;  // m, rad/s: ω²r = 4 m/s², which μ 0.41 holds
constexpr double turning = 3;                // s, nearly a turn

/// How far from the axis the cube is at the end [m]; it starts at (radius, 0).
double distance_from_axis(const Trajectory& trajectory) {
  const Vec3 displacement = trajectory.last().blocks[trajectory.block("cube")].displacement;
  return std::hypot(disc_radius + displacement.x(), displacement.y());
}

HardCaseExpectation keeps_its_place() {
  return {"the cube stays at its radius within 1 %", [](const Trajectory& trajectory) -> std::string {
            const double distance = distance_from_axis(trajectory);
            return std::abs(distance - disc_radius) < 0.01 * disc_radius
                       ? ""
                       : "it is " + decimals(distance, 4) + " m off the axis";
          }};
}

/// Without friction it leaves along the tangent: √(r² + (ωrt)²). With too little of it, outwards, but less far.
HardCaseExpectation slides_off(bool frictionless) {
  const double straight = disc_radius * std::hypot(1, spin * turning);
  return {frictionless ? "the cube goes straight on" : "the cube leaves, less far than without friction",
          [=](const Trajectory& trajectory) -> std::string {
            const double distance = distance_from_axis(trajectory);
            const bool so = frictionless ? std::abs(distance - straight) < 1e-3 * straight
                                         : distance > 1.2 * disc_radius && distance < straight;
            return so ? "" : "it is " + decimals(distance, 4) + " m off the axis for " + decimals(straight, 4);
          }};
}

/// A heavy disc that spins on a floor without friction, and a cube on it that goes along at first.
CaseScene turntable_scene(double friction) {
  CaseScene scene = scene_of(hard_stone(), friction);
  Material lead = hard_stone();
  lead.name = "heavy";
  lead.density *= 1000;  // the cube does not stop it
  const int heavy = scene.add_material(lead);
  scene.add_joint(joint_of("oiled", 0));
  scene.add_fixed_box("floor", {-12, -12, -2}, {12, 12, -1});
  scene.add_block("table", placed(prism(24, 8, 1), {0, 0, -1}), BodyKind::rigid, heavy);
  scene.add_block("cube", placed(cube(0.4), {disc_radius, 0, 0.2}), BodyKind::tetrahedra);
  scene.project.interfaces = {{{"floor", "table"}, "oiled"}};
  scene.project.velocities = {{.block = "table", .angular = {0, 0, spin}},
                              {.block = "cube", .linear = {0, spin * disc_radius, 0}, .angular = {0, 0, spin}}};
  scene.project.stages = {dynamic_stage(0.002, turning)};
  return scene;
}

HardCase turntable(double friction) {
  return {.name = "turntable_" + std::to_string(static_cast<int>(std::lround(10 * friction))),
          .group = classic_group,
          .title = "Cube on a turntable, ω²r 4 m/s², μ " + decimals(friction, 1),
          .source = "Ferguson et al. 2021 (rigid IPC)",
          .expected = {friction * 9.81 > spin * spin * disc_radius ? keeps_its_place() : slides_off(friction == 0)},
          .build = [=] { return turntable_scene(friction); }};
}

}  // namespace

std::vector<HardCase> friction_scenes() {
  return {incline(0.49), incline(0.50), stop(), turntable(0), turntable(0.1), turntable(0.5), turntable(1)};
}

}  // namespace talus
