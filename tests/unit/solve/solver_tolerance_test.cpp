#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "bodies/block_motion.hpp"
#include "model/solver_tolerances.hpp"
#include "model/stages.hpp"
#include "support/solver_scenes.hpp"

// SolverSettings::tolerance: how exactly steps are solved.
namespace talus {
namespace {

TEST(SolverTolerance, OfReferenceLeavesEveryValueAsItIs) {
  const SolverTolerances usual, same = usual.at(reference_tolerance.value);
  EXPECT_EQ(same.convergence.dynamic_residual, usual.convergence.dynamic_residual);
  EXPECT_EQ(same.convergence.static_residual, usual.convergence.static_residual);
  EXPECT_EQ(same.impact.impulse_accuracy, usual.impact.impulse_accuracy);
  EXPECT_EQ(same.impact.negligible_speed, usual.impact.negligible_speed);
  EXPECT_EQ(same.impact.sweep_limit, usual.impact.sweep_limit);
  const SolverTolerances finer = usual.at(1e-11);
  EXPECT_DOUBLE_EQ(finer.convergence.dynamic_residual, usual.convergence.dynamic_residual / 10);
  EXPECT_DOUBLE_EQ(finer.impact.impulse_accuracy, usual.impact.impulse_accuracy / 10);
  const SolverTolerances draft = usual.at(draft_tolerance.value);
  EXPECT_EQ(draft.convergence.dynamic_residual, usual.convergence.dynamic_residual) << "of all bodies together";
  EXPECT_GT(draft.impact.impulse_accuracy, usual.impact.impulse_accuracy);
  EXPECT_EQ(usual.at(standard_tolerance.value).impact.sweep_limit, 108);
  EXPECT_EQ(draft.impact.sweep_limit, 34);
}

TEST(SolverTolerance, DecidesWhoIsSlowEnoughToSleepAndWhatWakesIt) {
  const SolverTolerances usual, standard = usual.at(standard_tolerance.value), draft = usual.at(draft_tolerance.value);
  EXPECT_EQ(usual.at(reference_tolerance.value).sleep.speed, usual.sleep.speed);
  EXPECT_EQ(usual.at(1e-12).sleep.load_change, usual.sleep.load_change);
  EXPECT_DOUBLE_EQ(standard.sleep.speed, 1e-6);
  EXPECT_DOUBLE_EQ(standard.sleep.load_change, 1e-3);
  EXPECT_DOUBLE_EQ(draft.sleep.speed, 1e-5);
  EXPECT_DOUBLE_EQ(draft.sleep.load_change, 1e-2);
}

/// A block of 1 m slides down a plane, in steps that need iterations; tolerance and what came of it.
struct TolerantSlide {
  explicit TolerantSlide(double tolerance) {
    Project project = test::rock_project(15, {dynamic_stage(0.01, 1)});
    project.gravity = test::tilted_gravity(30);
    project.solver.tolerance = tolerance;
    const BlockSystem system = test::cube_on_slab();
    Simulation simulation(project, system);
    while (!simulation.finished()) {
      const StepReport report = simulation.step();
      iterations += report.iterations;
      worst_residual = std::max(worst_residual, report.unbalanced_force / weight);
    }
    converged = simulation.converged();
    displacement = block_motion(simulation.bodies(), 1).displacement.x();
  }
  static constexpr double weight = 2600 * 9.81;  // N
  int iterations = 0;
  double worst_residual = 0, displacement = 0;
  bool converged = false;
};

TEST(SolverTolerance, DecidesTheResidualTheIterationsAndTheError) {
  const TolerantSlide draft(draft_tolerance.value), standard(standard_tolerance.value),
      reference(reference_tolerance.value);
  for (const TolerantSlide* slide : {&draft, &standard, &reference}) EXPECT_TRUE(slide->converged);
  EXPECT_LT(draft.iterations, standard.iterations);
  EXPECT_LT(standard.iterations, reference.iterations);
  EXPECT_LT(draft.worst_residual, 3 * draft_tolerance.value) << "of the largest force, a few weights at the start";
  EXPECT_GT(draft.worst_residual, standard_tolerance.value) << "draft would be no other than standard";
  EXPECT_LT(standard.worst_residual, 3 * standard_tolerance.value);
  EXPECT_NEAR(draft.displacement / reference.displacement, 1, 1e-2);
  EXPECT_NEAR(standard.displacement / reference.displacement, 1, 1e-5);
}

TEST(SolverTolerance, IsOfEachBodySoThatAGrainBesideAMountainFalls) {
  Project project = test::rock_project(30, {dynamic_stage(0.01, 0.5)});
  project.solver.tolerance = draft_tolerance.value;
  const BlockSystem system =
      test::block_system({test::box_block("ground", Vec3(-500, -500, -1), Vec3(500, 500, 0), BodyKind::fixed),
                          test::box_block("mountain", Vec3(0, 0, 0), Vec3(100, 100, 100), BodyKind::rigid),
                          test::box_block("grain", Vec3(-3, 0, 50), Vec3(-2.8, 0.2, 50.2), BodyKind::rigid)});
  Simulation simulation(project, system);
  while (!simulation.finished()) simulation.step();
  ASSERT_TRUE(simulation.converged()) << simulation.failure();
  EXPECT_NEAR(block_motion(simulation.bodies(), 2).displacement.z() / (-0.5 * 9.81 * 0.25), 1, 1e-3);
}

TEST(SolverTolerance, DoesNotEndAStageBeforeItsEquilibrium) {
  const auto settlement = [](double tolerance) {
    Project project = test::rock_project(30, {static_stage(0.01, 500)});
    project.stages[0].until_equilibrium = true;
    project.solver.tolerance = tolerance;
    const BlockSystem system = test::cube_on_slab();
    Simulation simulation(project, system);
    bool equilibrium = false;
    while (!simulation.finished()) equilibrium = simulation.step().equilibrium;
    EXPECT_TRUE(equilibrium);
    return block_motion(simulation.bodies(), 1).displacement.z();
  };
  EXPECT_NEAR(settlement(0.01) / settlement(reference_tolerance.value), 1, 1e-4);
}

TEST(SolverTolerance, AtDraftABlockBelowItsFrictionAngleDoesNotCreep) {
  Project project = test::rock_project(35, {static_stage(0.01, 50), dynamic_stage(0.01, 10)});
  project.gravity = test::tilted_gravity(30);
  project.solver.tolerance = draft_tolerance.value;
  project.solver.sleep_tolerance = 0;
  const BlockSystem system = test::cube_on_slab();
  Simulation simulation(project, system);
  while (simulation.time() < 0.6) simulation.step();
  const Vec3 settled = block_motion(simulation.bodies(), 1).displacement;
  while (!simulation.finished()) simulation.step();
  EXPECT_LT((block_motion(simulation.bodies(), 1).displacement - settled).norm(), 1e-9);
}

/// A grain of 1 mm that leans on an edge falls flat on a cube of 1 m, whose positions are rounded by more of its force
/// than the grain weighs.
TEST(SolverTolerance, AGrainIsNoRoundingOfTheCubeItLiesOn) {
  constexpr double grain = 1e-3, lean = 0.17;  // m, rad
  const Project project = test::rock_project(30, {dynamic_stage(1e-3, 0.1)});
  BlockSystem system = test::block_system(
      {test::box_block("ground", Vec3(-3, -3, -1), Vec3(3, 3, 0), BodyKind::fixed),
       test::box_block("cube", Vec3(-0.5, -0.5, 0), Vec3(0.5, 0.5, 1), BodyKind::rigid),
       test::box_block("grain", Vec3(0.2, 0.1, 1), Vec3(0.2 + grain, 0.1 + grain, 1 + grain), BodyKind::rigid)});
  for (Vec3& node : system.blocks[2].mesh.nodes) {
    const double x = node.x() - 0.2, z = node.z() - 1;
    node = {0.2 + std::cos(lean) * x - std::sin(lean) * z, node.y(), 1 + std::sin(lean) * x + std::cos(lean) * z};
  }
  Simulation simulation(project, system);
  while (!simulation.finished()) simulation.step();
  ASSERT_TRUE(simulation.converged()) << simulation.failure();
  EXPECT_NEAR(block_motion(simulation.bodies(), 2).rotation, lean, 1e-3);
}

}  // namespace
}  // namespace talus
