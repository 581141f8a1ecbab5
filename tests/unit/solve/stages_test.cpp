// What stages change, and how they end.
#include <gmock/gmock.h>

#include "bodies/block_motion.hpp"
#include "support/solver_scenes.hpp"

namespace talus {
namespace {

void run_to_the_end(Simulation& simulation) {
  while (!simulation.finished()) simulation.step();
  ASSERT_TRUE(simulation.converged()) << simulation.failure();
}

TEST(Stages, StaticStageEndsInEquilibriumBeforeItsStepsAreUsedUp) {
  Stage settle{"settle", StageKind::static_, 0.01, 500, {}};
  settle.until_equilibrium = true;
  Project project = test::rock_project(35, {settle, {"rest", StageKind::dynamic, 0.01, 100, {}}});
  project.gravity = test::tilted_gravity(30);
  const BlockSystem system = test::cube_on_slab();
  Simulation simulation(project, system);
  StepReport report;
  int steps = 0;
  while (!simulation.stage_ended()) {
    report = simulation.step();
    ++steps;
  }
  EXPECT_TRUE(report.equilibrium);
  EXPECT_LT(steps, 100);
  const Vec3 settled = block_motion(simulation.bodies(), 1).displacement;
  const double ended = simulation.time();
  run_to_the_end(simulation);
  EXPECT_NEAR(simulation.time(), ended + 1, 1e-12);
  EXPECT_LT((block_motion(simulation.bodies(), 1).displacement - settled).norm(), 1e-9);
}

/// With full inertia in every step the column takes 525.
TEST(Stages, BlocksThatLeanOnEachOtherComeToRestInAFewStaticSteps) {
  Stage settle{"settle", StageKind::static_, 1e-3, 200, {}};
  settle.until_equilibrium = true;
  settle.equilibrium_tolerance = 1e-9;
  const Project project = test::rock_project(35, {settle});
  std::vector<Block> blocks{test::box_block("ground", Vec3(-1, -1, -1), Vec3(2, 2, 0), BodyKind::fixed)};
  for (int k = 0; k < 20; ++k)
    blocks.push_back(test::box_block("B" + std::to_string(k), Vec3(0, 0, k), Vec3(1, 1, k + 1), BodyKind::rigid));
  const BlockSystem system = test::block_system(blocks);
  Simulation simulation(project, system);
  int steps = 0;
  for (; !simulation.finished(); ++steps) simulation.step();
  EXPECT_LT(steps, 50);
}

TEST(Stages, SlidingInAStaticStageCreepsByTheSameDisplacementEachStep) {
  Project project = test::rock_project(15, {{"settle", StageKind::static_, 0.01, 40, {}}});
  project.gravity = test::tilted_gravity(30);
  const BlockSystem system = test::cube_on_slab();
  Simulation simulation(project, system);
  for (int k = 0; k < 20; ++k) simulation.step();
  const double half = block_motion(simulation.bodies(), 1).displacement.x();
  run_to_the_end(simulation);
  const double a = 9.81 * (std::sin(M_PI / 6) - std::tan(M_PI / 12) * std::cos(M_PI / 6)), beta = 9.0 / 16;
  EXPECT_NEAR((block_motion(simulation.bodies(), 1).displacement.x() - half) / (20 * beta * a * 1e-4), 1, 1e-4);
}

TEST(Stages, WhatSlidesNeverComesToEquilibrium) {
  Stage settle{"settle", StageKind::static_, 0.01, 50, {}};
  settle.until_equilibrium = true;
  Project project = test::rock_project(15, {settle});
  project.gravity = test::tilted_gravity(30);
  const BlockSystem system = test::cube_on_slab();
  Simulation simulation(project, system);
  run_to_the_end(simulation);
  EXPECT_NEAR(simulation.time(), 0.5, 1e-12);
}

TEST(Stages, JointThatLosesItsStrengthLetsTheBlockGo) {
  Stage rest{"rest", StageKind::dynamic, 0.01, 50, {}}, slide = rest;
  slide.name = "slide";
  slide.joints = {{"J", 10.0, {}, {}, {}}};
  Project project = test::rock_project(35, {rest, slide});
  project.gravity = test::tilted_gravity(30);
  const BlockSystem system = test::cube_on_slab();
  Simulation simulation(project, system);
  while (!simulation.stage_ended()) simulation.step();
  EXPECT_LT(block_motion(simulation.bodies(), 1).velocity.norm(), 1e-3);
  run_to_the_end(simulation);
  const double expected = 9.81 * (std::sin(M_PI / 6) - std::tan(M_PI / 18) * std::cos(M_PI / 6)) * 0.5;
  EXPECT_NEAR(block_motion(simulation.bodies(), 1).velocity.x() / expected, 1, 0.01);
}

/// A static stage leaves a creeping block on the border between sticking and sliding.
TEST(Stages, SlidingGoesOnWithItsWholeAccelerationAfterAStaticStage) {
  for (const Integrator integrator : {Integrator::newmark, Integrator::generalized_alpha}) {
    Project project = test::rock_project(
        15, {{"settle", StageKind::static_, 0.001, 20, {}}, {"slide", StageKind::dynamic, 0.01, 5, {}}});
    project.gravity = test::tilted_gravity(30);
    project.solver.integrator = integrator;
    const BlockSystem system = test::cube_on_slab();
    Simulation simulation(project, system);
    while (!simulation.stage_ended()) simulation.step();
    const double start = block_motion(simulation.bodies(), 1).displacement.x();
    run_to_the_end(simulation);
    const double a = 9.81 * (std::sin(M_PI / 6) - std::tan(M_PI / 12) * std::cos(M_PI / 6)), t = 0.05;
    EXPECT_NEAR((block_motion(simulation.bodies(), 1).displacement.x() - start) / (a * t * t / 2), 1, 1e-5);
  }
}

TEST(Stages, BlockHeldInAStageStandsStillKeepsItsStressAndFallsWhenLetGo) {
  Stage wait{"wait", StageKind::dynamic, 0.01, 20, {}}, fall{"fall", StageKind::dynamic, 0.01, 50, {}};
  wait.blocks = {{"B", BodyKind::fixed}};
  fall.blocks = {{"B", BodyKind::tetrahedra}};
  Project project = test::rock_project(0, {wait, fall});
  project.in_situ.emplace_back();
  project.in_situ[0].stress << -1e5, -1e5, -1e5, 0, 0, 0;
  for (const Strain strain : {Strain::incremental, Strain::corotational}) {
    project.solver.strain = strain;
    const BlockSystem system = test::block_system(
        {test::box_block("B", Vec3(0, 0, 5), Vec3(1, 1, 6)), test::box_block("C", Vec3(3, 0, 5), Vec3(4, 1, 6))});
    Simulation simulation(project, system);
    while (!simulation.stage_ended()) simulation.step();
    EXPECT_EQ(simulation.bodies().nodes.position[0], simulation.bodies().nodes.reference[0]);
    EXPECT_NEAR(simulation.frame(0).stress[0][0], -1e5, 1);
    EXPECT_NEAR(block_motion(simulation.bodies(), 1).displacement.z(), -0.5 * 9.81 * 0.04, 1e-9);
    run_to_the_end(simulation);
    EXPECT_NEAR(block_motion(simulation.bodies(), 0).displacement.z(), -0.5 * 9.81 * 0.25, 1e-6);
    EXPECT_NEAR(block_motion(simulation.bodies(), 1).displacement.z(), -0.5 * 9.81 * 0.49, 1e-6);
  }
}

TEST(Stages, LoadByTablePushesAsItsTableSays) {
  // A force that grows as t from nothing: ∫∫ F/m = F' t³/6m.
  Project project = test::rock_project(0, {{"push", StageKind::dynamic, 0.001, 1000, {}}});
  project.gravity = Vec3::Zero();
  project.solver.integrator = Integrator::generalized_alpha;
  project.solver.spectral_radius = 1;
  project.loads = {{"B", Vec3(0.5, 0.5, 0.5), Vec3::Zero(), {{0, Vec3::Zero()}, {1, Vec3(2600, 0, 0)}}}};
  const BlockSystem system = test::block_system({test::box_block("B", Vec3(0, 0, 0), Vec3(1, 1, 1))});
  Simulation simulation(project, system);
  run_to_the_end(simulation);
  EXPECT_NEAR(block_motion(simulation.bodies(), 0).displacement.x() * 6, 1, 1e-5);
}

TEST(Stages, HeldPointFollowsItsTable) {
  Project project = test::rock_project(0, {{"lift", StageKind::static_, 0.1, 100, {}}});
  project.gravity = Vec3::Zero();
  for (int i = 0; i < 4; ++i)
    project.constraints.push_back(
        {"B", Vec3(i & 1, i >> 1, 0), {0, {}, 0}, {{0, Vec3::Zero()}, {5, Vec3(0, 7, 0.2)}, {20, Vec3(0, 7, 0.2)}}});
  const BlockSystem system = test::block_system({test::box_block("B", Vec3(0, 0, 0), Vec3(1, 1, 1))});
  Simulation simulation(project, system);
  run_to_the_end(simulation);
  EXPECT_NEAR(simulation.frame(0).displacement[0].z(), 0.2, 1e-6);
  EXPECT_NEAR(simulation.frame(0).displacement[0].y(), 0, 1e-7) << "a free component followed the table";
}

TEST(Stages, AdaptiveStepsKeepTheirLimitsAndLandWhereFixedOnesDo) {
  Project project = test::rock_project(15, {{"slide", StageKind::dynamic, 0.05, {}, 1.0}});
  project.gravity = test::tilted_gravity(30);
  project.solver.time_step_control = TimeStepControl::adaptive;
  project.solver.adaptive.displacement_limit = 0.02;
  const BlockSystem system = test::cube_on_slab();
  Simulation simulation(project, system);
  double largest = 0, shortest = 1, longest = 0;
  while (!simulation.finished()) {
    const StepReport report = simulation.step();
    largest = std::max(largest, report.max_displacement);
    if (!simulation.finished()) shortest = std::min(shortest, report.time_step);
    longest = std::max(longest, report.time_step);
  }
  EXPECT_EQ(simulation.time(), 1.0);
  EXPECT_LE(largest, 1.5 * 0.02 * 1.0);  // half height: 1 m
  EXPECT_LT(shortest, 0.3 * longest);
  const double expected = 9.81 * (std::sin(M_PI / 6) - std::tan(M_PI / 12) * std::cos(M_PI / 6));
  EXPECT_NEAR(block_motion(simulation.bodies(), 1).velocity.x() / expected, 1, 2e-3);
}

TEST(Stages, AugmentedLagrangianBringsPenetrationToItsTolerance) {
  Project project = test::rock_project(30, {{"settle", StageKind::static_, 0.01, 40, {}}});
  project.materials[0].density = 2.6e6;  // heavy, so that there is something to bring down
  const BlockSystem system = test::cube_on_slab();
  const auto penetration = [&] {
    Simulation simulation(project, system);
    double last = 0;
    while (!simulation.finished()) last = simulation.step().max_relative_penetration;
    EXPECT_TRUE(simulation.converged()) << simulation.failure();
    return last;
  };
  const double plain = penetration();
  EXPECT_GT(plain, 1e-5);
  project.solver.penetration_tolerance = 1e-8;
  EXPECT_LT(penetration(), 1e-8);
}

}  // namespace
}  // namespace talus
