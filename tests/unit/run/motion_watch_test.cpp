#include "run/motion_watch.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "base/line_attitude.hpp"
#include "base/units.hpp"
#include "solve/simulation.hpp"
#include "support/small_scenes.hpp"

namespace talus {
namespace {

/// Blocks on a table whose plane is z = 0, the gravity of a plane that dips by `dip` degrees towards +x.
struct TiltedTable {
  TiltedTable(double dip, double friction_angle) {
    project.materials = {{"rock", 2600, 5e9, 0.24}};
    project.joints = {{"J", friction_angle, 0, 0, {}, {}, {}, {}}};
    project.default_joint = "J";
    project.gravity = 9.81 * Vec3(std::sin(radians(dip)), 0, -std::cos(radians(dip)));
    system.joint_names = {"J"};
    system.blocks = {test::box_block("table", Vec3(-5, -5, -1), Vec3(20, 5, 0), BodyKind::fixed)};
    system.solids_volume = 1;
  }
  void add(const std::string& name, const Vec3& min, const Vec3& max) {
    system.blocks.push_back(test::box_block(name, min, max));
  }
  void stage(StageKind kind, double time_step, int steps) {
    project.stages.push_back({"stage", kind, time_step, steps, {}});
  }
  Project project;
  BlockSystem system;
};

struct Seen {
  std::vector<MotionClass> classes;
  std::vector<Event> events;
  int asleep = 0;  // blocks, at the end
  std::vector<std::string> told() const {
    std::vector<std::string> words;
    for (const Event& event : events) words.push_back(event.what);
    return words;
  }
};

Seen watch(const TiltedTable& scene) {
  Simulation simulation(scene.project, scene.system);
  MotionWatch motions(scene.project, scene.system, simulation.bodies());
  int asleep = 0;
  while (!simulation.finished()) {
    asleep = simulation.step().asleep;
    motions.look(simulation.time(), simulation.stage_ended(), simulation.bodies(), simulation.awake_contacts());
  }
  EXPECT_TRUE(simulation.converged()) << simulation.failure();
  return {motions.classes(simulation.bodies()), motions.events(), asleep};
}

TEST(MotionWatch, ABlockAboveItsFrictionAngleSlidesAfterAStaticStageInWhichItWasHeld) {
  TiltedTable scene(30, 15);
  scene.add("B", Vec3(0, 0, 0), Vec3(1, 1, 1));
  scene.stage(StageKind::static_, 0.01, 20);
  scene.stage(StageKind::dynamic, 0.01, 60);
  const Seen seen = watch(scene);
  EXPECT_EQ(seen.classes[0].mode, MotionMode::stable);
  EXPECT_EQ(seen.classes[1].mode, MotionMode::sliding_on_one);
  EXPECT_EQ(seen.classes[1].joints, (std::array{0, -1}));
  EXPECT_FALSE(seen.classes[1].came_to_rest);
  EXPECT_GT(seen.classes[1].direction.x(), 1 - 1e-6);
  EXPECT_THAT(seen.told(), testing::ElementsAre("B: sliding on J (table)"));
}

TEST(MotionWatch, TheFirstHundredthsOfASlideAreToldFromRest) {
  // After 0.02 s the block has slid by ½ · 2.63 · 0.02² = 5e-4 m; at 0.004 s by 2e-5 m, which only accelerates.
  for (const int steps : {16, 80}) {
    TiltedTable scene(30, 15);
    scene.add("B", Vec3(0, 0, 0), Vec3(1, 1, 1));
    scene.stage(StageKind::static_, 0.001, 100);
    scene.stage(StageKind::dynamic, 0.00025, steps);
    EXPECT_EQ(watch(scene).classes[1].mode, MotionMode::sliding_on_one) << steps;
  }
}

TEST(MotionWatch, ABlockBelowItsFrictionAngleIsStableSoftRockToo) {
  TiltedTable scene(30, 35);
  scene.project.materials[0].young = 1e7;
  scene.add("B", Vec3(0, 0, 0), Vec3(1, 1, 1));
  scene.stage(StageKind::dynamic, 0.01, 200);
  const Seen seen = watch(scene);
  EXPECT_EQ(seen.classes[1], MotionClass{});
  EXPECT_TRUE(seen.events.empty());
}

TEST(MotionWatch, ABlockWithoutSupportFalls) {
  TiltedTable scene(0, 30);
  scene.add("B", Vec3(0, 0, 3), Vec3(1, 1, 4));
  scene.stage(StageKind::dynamic, 0.01, 10);
  const Seen seen = watch(scene);
  EXPECT_EQ(seen.classes[1].mode, MotionMode::falling);
  EXPECT_NEAR(attitude_of(seen.classes[1].direction).plunge, 90, 1e-6);
}

TEST(MotionWatch, ASlenderColumnTopplesWithoutSlip) {
  TiltedTable scene(20, 50);  // tan 20° = 0.36 > width / height = 0.25
  scene.add("B", Vec3(0, 0, 0), Vec3(1, 2, 4));
  scene.stage(StageKind::dynamic, 0.01, 60);
  const Seen seen = watch(scene);
  EXPECT_EQ(seen.classes[1].mode, MotionMode::toppling);
  EXPECT_GT(seen.classes[1].axis.y(), 0.999);
  EXPECT_GT(seen.classes[1].direction.x(), 0.9);
  EXPECT_THAT(seen.told(), testing::ElementsAre("B: toppling on J (table)"));
}

TEST(MotionWatch, ABlockThatSpinsOnItsBaseIsTorsionalAndComesToRest) {
  TiltedTable scene(0, 20);
  scene.add("B", Vec3(0, 0, 0), Vec3(1, 1, 0.4));
  scene.project.velocities = {{"B", Vec3::Zero(), Vec3(0, 0, 1.5)}};
  scene.stage(StageKind::dynamic, 0.01, 10);
  EXPECT_EQ(watch(scene).classes[1].mode, MotionMode::torsional);
  scene.project.stages[0].steps = 150;
  const Seen seen = watch(scene);
  EXPECT_EQ(seen.classes[1].mode, MotionMode::torsional);
  EXPECT_TRUE(seen.classes[1].came_to_rest);
  EXPECT_GT(seen.classes[1].axis.z(), 0.999);
  ASSERT_THAT(seen.told(),
              testing::ElementsAre("B: torsional on J (table)", "B: torsional on J (table), came to rest"));
  // ω / α with α = 6 μ g ρ: ρ = 0.707 m where the corners carry all, 0.383 m where the pressure is uniform.
  EXPECT_GT(seen.events[1].time, 0.09);
  EXPECT_LT(seen.events[1].time, 0.19);
}

TEST(MotionWatch, ABlockThatHasSlidToAStopSaysSo) {
  TiltedTable scene(0, 20);
  scene.add("B", Vec3(0, 0, 0), Vec3(1, 1, 0.4));
  scene.project.velocities = {{"B", Vec3(0, -1, 0), Vec3::Zero()}};
  scene.stage(StageKind::dynamic, 0.01, 100);
  const Seen seen = watch(scene);
  EXPECT_EQ(seen.classes[1].mode, MotionMode::sliding_on_one);
  EXPECT_TRUE(seen.classes[1].came_to_rest);
  EXPECT_NEAR(attitude_of(seen.classes[1].direction).trend, 180, 0.1);
  ASSERT_EQ(seen.events.size(), 2u);
  EXPECT_NEAR(seen.events[1].time, 1 / (std::tan(radians(20)) * 9.81), 0.03);
}

TEST(MotionWatch, WhoFallsAsleepKeepsTheClassItCameToRestWith) {
  TiltedTable scene(0, 20);
  scene.add("B", Vec3(0, 0, 0), Vec3(1, 1, 0.4));
  scene.add("C", Vec3(4, 0, 0), Vec3(5, 1, 0.4));
  scene.project.velocities = {{"B", Vec3(0, -1, 0), Vec3::Zero()}};
  scene.stage(StageKind::dynamic, 0.01, 400);
  const Seen slept = watch(scene);
  EXPECT_EQ(slept.asleep, 2);
  scene.project.solver.sleep_tolerance = 0;
  const Seen never = watch(scene);
  EXPECT_EQ(never.asleep, 0);
  EXPECT_EQ(slept.told(), never.told());
  ASSERT_EQ(slept.events.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(slept.events[i].time, never.events[i].time, 1e-9);
  for (const int block : {1, 2}) EXPECT_TRUE(same_kind(slept.classes[block], never.classes[block])) << block;
  EXPECT_TRUE(slept.classes[1].came_to_rest);
  EXPECT_EQ(slept.classes[2].mode, MotionMode::stable);
}

TEST(MotionWatch, WhatRidesOnASlidingBlockIsCarriedByIt) {
  TiltedTable scene(20, 10);
  scene.project.joints.push_back({"rough", 60, 0, 0, {}, {}, {}, {}});
  scene.system.joint_names.push_back("rough");
  scene.project.interfaces = {{{"lower", "upper"}, "rough"}};
  scene.add("lower", Vec3(0, 0, 0), Vec3(2, 2, 0.5));
  scene.add("upper", Vec3(0.5, 0.5, 0.5), Vec3(1.5, 1.5, 1));
  scene.stage(StageKind::dynamic, 0.01, 60);
  const Seen seen = watch(scene);
  EXPECT_EQ(motion_text(seen.classes[1], motion_names(scene.system)), "sliding on J (table)");
  EXPECT_EQ(motion_text(seen.classes[2], motion_names(scene.system)), "carried by lower");
  EXPECT_GT(seen.classes[2].direction.x(), 0.999);
}

TEST(MotionWatch, ABlockInATroughSlidesAlongTheLineOfTwoPlanes) {
  // A trough of two planes through the x axis, 45° each; a prism lies in it, gravity pulls along.
  TiltedTable scene(25, 5);
  Block prism = test::box_block("prism", Vec3(0, 0, 0), Vec3(1, 1, 1));
  Block left = test::box_block("left", Vec3(-3, -1, -3), Vec3(6, 0, 3), BodyKind::fixed);
  Block right = test::box_block("right", Vec3(-3, 0, -1), Vec3(6, 3, 0), BodyKind::fixed);
  for (Block* block : {&prism, &left, &right})
    for (Vec3& x : block->mesh.nodes)
      x = Vec3(x.x(), (x.y() - x.z()) * std::sqrt(0.5), (x.y() + x.z()) * std::sqrt(0.5));
  scene.system.blocks = {left, right, prism};
  scene.stage(StageKind::dynamic, 0.01, 50);
  const Seen seen = watch(scene);
  EXPECT_EQ(seen.classes[2].mode, MotionMode::sliding_on_two);
  EXPECT_EQ(seen.classes[2].against, (std::array{0, 1}));
  EXPECT_GT(seen.classes[2].line.x(), 1 - 1e-6);
  EXPECT_GT(seen.classes[2].direction.x(), 0.9999);
}

TEST(MotionWatch, ABlockThatLeavesTheTableSlidesAndThenFalls) {
  TiltedTable scene(0, 0);
  scene.system.blocks = {test::box_block("table", Vec3(-5, -2, -0.5), Vec3(0, 3, 0), BodyKind::fixed)};
  scene.add("B", Vec3(-1, 0, 0), Vec3(0, 1, 0.5));
  scene.project.velocities = {{"B", Vec3(3, 0, 0), Vec3::Zero()}};
  scene.stage(StageKind::dynamic, 0.01, 100);
  const Seen seen = watch(scene);
  EXPECT_EQ(seen.classes[1].mode, MotionMode::falling);
  ASSERT_FALSE(seen.events.empty());
  EXPECT_EQ(seen.events.front().what, "B: sliding on J (table)");
  EXPECT_LT(seen.events.size(), 4u);
}

}  // namespace
}  // namespace talus
