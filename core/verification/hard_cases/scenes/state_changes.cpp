#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/units.hpp"
#include "model/number_text.hpp"
#include "model/stages.hpp"
#include "verification/hard_cases/expectations.hpp"
#include "verification/hard_cases/scenes/scene_groups.hpp"
#include "verification/hard_cases/shapes.hpp"

// What holds at one time and no longer at the next: strength, support, the base, velocity, the direction of a load.
namespace talus {

namespace {

const char* const state_group = "state changes";
constexpr double state_gravity = 9.81;  // m/s²

/// Distance slid in `seconds` from rest of a block on an incline of 30° [m].
double slide_on_30(double friction_angle, double seconds) {
  const double pull = std::sin(radians(30)) - std::tan(radians(friction_angle)) * std::cos(radians(30));
  return state_gravity * pull * seconds * seconds / 2;
}

CaseScene block_on_30(double friction_angle) {
  CaseScene scene = rock_scene(friction_angle);
  tilt(scene, 30);
  scene.add_fixed_box("slab", {-2, -2, -1}, {8, 2, 0});
  scene.add_block("block", box_mesh({-0.5, -0.5, 0}, {0.5, 0.5, 1}, 1, 1, 1), BodyKind::rigid);
  scene.project.solver.sleep_tolerance = 0;
  return scene;
}

/// What bears for a second bears no more in the next.
void weaken_after_a_second(CaseScene& scene, const JointChange& weaker) {
  scene.project.stages = {static_stage(0.01, 20), dynamic_stage(2e-3, 1), dynamic_stage(2e-3, 1)};
  scene.project.stages[2].joints = {weaker};
}

JointChange friction_of(double angle) {
  JointChange change;
  change.name = "joint";
  change.friction_angle = angle;
  return change;
}

JointChange no_bond() {
  JointChange change;
  change.name = "joint";
  change.cohesion = change.tensile_strength = 0;
  return change;
}

/// Friction of 40° holds the block for a second and is 10° from then on.
HardCase friction_drops() {
  return {.name = "friction_drops",
          .group = state_group,
          .title = "Friction of a block on 30° drops from 40° to 10°",
          .expected = {travels("block", Vec3::UnitX(), slide_on_30(10, 1), 1e-3)},
          .build = [] {
            CaseScene scene = block_on_30(40);
            weaken_after_a_second(scene, friction_of(10));
            return scene;
          }};
}

/// 1e5 Pa of cohesion bear eight times the pull of 1.3e4 Pa; then nothing does.
HardCase cohesion_drops() {
  return {.name = "cohesion_drops",
          .group = state_group,
          .title = "Cohesion that alone holds a block on 30° vanishes",
          .expected = {travels("block", Vec3::UnitX(), slide_on_30(0, 1), 1e-3)},
          .build = [] {
            CaseScene scene = block_on_30(0);
            scene.project.joints[0].cohesion = 1e5;
            weaken_after_a_second(scene, no_bond());
            return scene;
          }};
}

/// A block of 2.6e4 Pa of weight hangs from a roof by 1e6 Pa of tensile strength, and then by none.
HardCase tension_drops() {
  return {.name = "tension_drops",
          .group = state_group,
          .title = "Tensile strength by which a block hangs from a roof vanishes",
          .source = "g t²/2",
          .expected = {travels("block", -Vec3::UnitZ(), state_gravity / 2, 1e-3)},
          .build = [] {
            CaseScene scene = rock_scene(30);
            scene.project.joints[0].cohesion = scene.project.joints[0].tensile_strength = 1e6;
            scene.add_fixed_box("roof", {-2, -2, 1}, {2, 2, 2});
            scene.add_block("block", box_mesh({-0.5, -0.5, 0}, {0.5, 0.5, 1}, 1, 1, 1), BodyKind::rigid);
            scene.project.solver.sleep_tolerance = 0;
            weaken_after_a_second(scene, no_bond());
            return scene;
          }};
}

/// A prop that is held 5 cm above the floor carries two blocks; let go, all fall by that and stay.
HardCase support_falls() {
  constexpr double drop = 0.05;  // m
  std::vector<HardCaseExpectation> expectations;
  for (const char* block : {"prop", "block 1", "block 2"}) {
    expectations.push_back(travels(block, -Vec3::UnitZ(), drop, 0.01));
    expectations.push_back(stops(block, 1e-3));
  }
  return {.name = "support_falls",
          .group = state_group,
          .title = "Prop under two blocks is let go and falls with them by 5 cm",
          .expected = expectations,
          .build = [] {
            CaseScene scene = rock_scene(30);
            scene.add_fixed_box("floor", {-3, -3, -1}, {3, 3, 0});
            const char* const names[] = {"prop", "block 1", "block 2"};
            for (int i = 0; i < 3; ++i)
              scene.add_block(names[i], box_mesh({-0.5, -0.5, drop + i}, {0.5, 0.5, drop + i + 1}, 1, 1, 1),
                              BodyKind::rigid);
            scene.project.stages = {static_stage(0.01, 20), dynamic_stage(1e-3, 0.2), dynamic_stage(1e-3, 2)};
            scene.project.stages[0].blocks = {{.name = "prop", .body = BodyKind::fixed}};
            scene.project.stages[2].blocks = {{.name = "prop", .body = BodyKind::rigid}};
            return scene;
          }};
}

/// A held toe carries a block that friction of 20° does not hold on 30°; let go, both slide as one.
HardCase toe_removed() {
  const double distance = slide_on_30(20, 1);
  return {.name = "toe_removed",
          .group = state_group,
          .title = "Toe that holds a block on 30° is let go",
          .expected = {travels("block", Vec3::UnitX(), distance, 1e-3), travels("toe", Vec3::UnitX(), distance, 1e-3)},
          .build = [] {
            CaseScene scene = block_on_30(20);
            scene.add_block("toe", box_mesh({0.5, -0.5, 0}, {1.5, 0.5, 1}, 1, 1, 1), BodyKind::rigid);
            scene.project.stages = {static_stage(0.01, 20), dynamic_stage(2e-3, 0.5), dynamic_stage(2e-3, 1)};
            scene.project.stages[0].blocks = {{.name = "toe", .body = BodyKind::fixed}};
            scene.project.stages[2].blocks = {{.name = "toe", .body = BodyKind::rigid}};
            return scene;
          }};
}

/// The block's centroid goes as far to the side as that at least [m].
HardCaseExpectation sways(const std::string& block, const Vec3& direction, double least) {
  return {block + " sways by at least " + significant(least) + " m", [=](const Trajectory& trajectory) {
            double most = 0;
            for (const Snapshot& snapshot : trajectory.snapshots)
              most = std::max(most, std::abs(snapshot.blocks[trajectory.block(block)].displacement.dot(direction)));
            return most >= least ? std::string() : "it sways by " + significant(most) + " m";
          }};
}

/// The first bending mode of a clamped column, 0.56/L² √(EI/ρA), lies at 2.5 Hz. A sweep magnifies its base's motion by
/// 3.7 f/√(rate) = 15 (Lewis 1932), its tip's by 1.57 times that and its centroid's by 0.39 times that of its tip. The
/// tip's 1.4 m/s² lift no edge of a column 4 : 1.
HardCase resonance() {
  constexpr double amplitude = 0.25e-3, time_step = 2.5e-3;       // m, s
  constexpr double start = 0.2, length = 10, slow = 1, fast = 5;  // s, s, Hz, Hz
  return {.name = "resonance",
          .group = state_group,
          .title = "Base under an elastic column shaken by 0.25 mm from 1 to 5 Hz, through its own 2.5 Hz",
          .expected = {rests("column", 0, 20 * amplitude, 0.5), sways("column", Vec3::UnitX(), 3 * amplitude)},
          .build = [=] {
            CaseScene scene = rock_scene(45);
            scene.project.materials[0].young = 4e7;
            scene.add_fixed_box("base", {-2, -2, -1}, {2, 2, 0});
            scene.add_block("column", box_mesh({-0.25, -0.25, 0}, {0.25, 0.25, 2}, 2, 2, 8), BodyKind::tetrahedra);
            Constraint shaking;
            shaking.block = "base";
            for (double t = 0; t < length; t += time_step) {
              const double cycles = slow * t + (fast - slow) * t * t / (2 * length);
              shaking.table.push_back({start + t, {amplitude * std::sin(2 * std::numbers::pi * cycles), 0, 0}});
            }
            scene.project.constraints = {shaking};
            scene.project.stages = {static_stage(start / 20, 20), dynamic_stage(time_step, length)};
            return scene;
          }};
}

/// Equilibrium found without inertia is one with it: nothing moves on.
HardCase handed_over() {
  return {.name = "static_to_dynamic",
          .group = state_group,
          .title = "Stack of five soft cubes, after a static stage, goes on with inertia",
          .expected = {all_rest(0, 1e-6)},
          .build = [] {
            CaseScene scene = rock_scene(30);
            scene.project.materials[0].young = 1e9;
            scene.add_fixed_box("floor", {-3, -3, -1}, {3, 3, 0});
            for (int i = 0; i < 5; ++i)
              scene.add_block("cube " + std::to_string(i + 1),
                              box_mesh(Vec3(-0.5, -0.5, i), Vec3(0.5, 0.5, i + 1), 2, 2, 2), BodyKind::tetrahedra);
            scene.project.solver.sleep_tolerance = 0;
            scene.project.stages = {static_stage(0.1, 500), dynamic_stage(2e-3, 2)};
            scene.project.stages[0].until_equilibrium = true;
            scene.project.stages[0].equilibrium_tolerance = 1e-8;
            return scene;
          }};
}

/// Velocity is gone after a static stage: twice the distance of one second instead of the distance of two.
HardCase stopped_between() {
  return {.name = "dynamic_to_static_and_on",
          .group = state_group,
          .title = "Block that slides on 30° is stopped by a static stage and slides on",
          .expected = {travels("block", Vec3::UnitX(), 2 * slide_on_30(20, 1), 1e-2)},
          .build = [] {
            CaseScene scene = block_on_30(20);
            scene.project.stages = {dynamic_stage(2e-3, 1), static_stage(2e-3, 5), dynamic_stage(2e-3, 1)};
            return scene;
          }};
}

/// Pushed for a second by a share of what friction of 30° bears, one way and then the other. Below 1 nothing slides.
/// At 1.5 the block gains μg/2 for a second, loses 5μg/2 until it stands at 1.2 s, and gains μg/2 the other way.
HardCase load_reversed(bool slides) {
  const double share = slides ? 1.5 : 0.9, friction = std::tan(radians(30)), mass = 2600;
  const double there = 0.5 * friction * state_gravity / 2, on = there / 5, back = 0.8 * 0.8 * there;
  std::vector<HardCaseExpectation> expectations{rests("block", 0, 1e-6)};
  if (slides) expectations = {travels("block", Vec3::UnitX(), there + on - back, 1e-2)};
  return {.name = std::string("load_reversed_") + (slides ? "slides" : "rests"),
          .group = state_group,
          .title = std::string("Push at ") + (slides ? "150" : "90") + " % of friction is reversed at once",
          .expected = expectations,
          .build = [=] {
            CaseScene scene = rock_scene(30);
            scene.add_fixed_box("floor", {-3, -3, -1}, {6, 3, 0});
            scene.add_block("block", box_mesh({-0.5, -0.5, 0}, {0.5, 0.5, 1}, 1, 1, 1), BodyKind::rigid);
            scene.project.solver.sleep_tolerance = 0;
            scene.project.stages = {static_stage(0.01, 20), dynamic_stage(1e-3, 1), dynamic_stage(1e-3, 1)};
            for (const int stage : {1, 2}) {
              const double force = (stage == 1 ? share : -share) * friction * mass * state_gravity;
              scene.project.stages[stage].loads = {{{.block = "block", .at = {0, 0, 0.5}, .force = {force, 0, 0}}}};
            }
            return scene;
          }};
}

}  // namespace

std::vector<HardCase> state_change_scenes() {
  return {friction_drops(), cohesion_drops(), tension_drops(),   support_falls(),      toe_removed(),
          resonance(),      handed_over(),    stopped_between(), load_reversed(false), load_reversed(true)};
}

}  // namespace talus
