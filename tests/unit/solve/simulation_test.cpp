#include "solve/simulation.hpp"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <cmath>

#include "base/parallel.hpp"
#include "bodies/block_motion.hpp"
#include "mesh/structured_mesh.hpp"
#include "support/solver_scenes.hpp"

namespace talus {
namespace {

using test::tilted_gravity;
constexpr auto scene = test::rock_project;
constexpr auto blocks = test::block_system;

TEST(Simulation, FreeFallIsExact) {
  const Project project = scene(30, {{"fall", StageKind::dynamic, 0.01, 100, {}}});
  const BlockSystem system = blocks({test::box_block("B", Vec3(0, 0, 10), Vec3(1, 1, 11))});
  Simulation simulation(project, system);
  while (!simulation.finished()) simulation.step();
  const BlockMotion motion = block_motion(simulation.bodies(), 0);
  EXPECT_NEAR(motion.displacement.z() / (-0.5 * 9.81), 1, 1e-10);
  EXPECT_NEAR(motion.velocity.z() / -9.81, 1, 1e-10);
}

TEST(Simulation, BlockOnAPlaneSlidesAtTheAccelerationOfCoulomb) {
  Project project =
      scene(15, {{"settle", StageKind::static_, 0.01, 20, {}}, {"slide", StageKind::dynamic, 0.01, 100, {}}});
  project.gravity = tilted_gravity(30);
  const BlockSystem system = blocks({test::box_block("ground", Vec3(-5, -5, -1), Vec3(20, 5, 0), BodyKind::fixed),
                                     test::box_block("B", Vec3(0, 0, 0), Vec3(1, 1, 1))});
  Simulation simulation(project, system);
  int iterations = 0;
  while (!simulation.finished()) iterations += simulation.step().iterations;
  ASSERT_TRUE(simulation.converged()) << simulation.failure();
  const double expected = 9.81 * (std::sin(M_PI / 6) - std::tan(M_PI / 12) * std::cos(M_PI / 6));
  EXPECT_NEAR(block_motion(simulation.bodies(), 1).velocity.x() / expected, 1, 1e-3);
  RecordProperty("iterations", iterations);
  EXPECT_LT(iterations, 120 * 4);
}

TEST(Simulation, BlockBelowItsFrictionAngleDoesNotCreep) {
  Project project =
      scene(35, {{"settle", StageKind::static_, 0.01, 50, {}}, {"rest", StageKind::dynamic, 0.01, 1000, {}}});
  project.gravity = tilted_gravity(30);
  const BlockSystem system = blocks({test::box_block("ground", Vec3(-5, -5, -1), Vec3(20, 5, 0), BodyKind::fixed),
                                     test::box_block("B", Vec3(0, 0, 0), Vec3(1, 1, 1))});
  Simulation simulation(project, system);
  while (simulation.time() < 0.5) simulation.step();
  const Vec3 settled = block_motion(simulation.bodies(), 1).displacement;
  while (!simulation.finished()) simulation.step();
  EXPECT_LT((block_motion(simulation.bodies(), 1).displacement - settled).norm(), 1e-9);
}

TEST(Simulation, BlockDroppedOnAnotherLandsAndRestsWithoutGainingEnergy) {
  const Project project = scene(30, {{"drop", StageKind::dynamic, 0.005, 800, {}}});
  const BlockSystem system = blocks({test::box_block("ground", Vec3(0, 0, -1), Vec3(4, 4, 0), BodyKind::fixed),
                                     test::box_block("lower", Vec3(1, 1, 0), Vec3(3, 3, 1)),
                                     test::box_block("upper", Vec3(1.3, 1.2, 1.2), Vec3(2.3, 2.4, 2.2))});
  Simulation simulation(project, system);
  StepReport last;
  double worst_gain = 0;
  while (!simulation.finished()) {
    last = simulation.step();
    worst_gain = std::min(worst_gain, last.energy.integration_loss);
  }
  ASSERT_TRUE(simulation.converged()) << simulation.failure();
  const double fall_energy = 2600 * 1.2 * 9.81 * 0.2;
  EXPECT_GT(worst_gain, -1e-3 * fall_energy) << "the scene gained energy from nowhere";
  EXPECT_NEAR(block_motion(simulation.bodies(), 2).displacement.z(), -0.2, 1e-3);
  EXPECT_LT(last.energy.kinetic, 1e-3 * fall_energy);
  EXPECT_LT(last.max_relative_penetration, 1e-3);
}

TEST(Simulation, BarPulledByAPointLoadAndHeldAtItsFootStretchesAsHookeSays) {
  // One column of tetrahedra, held at every node of the foot, pulled at every node of the top: uniform stress needs
  // consistent nodal forces, which for Kuhn's split of the top square are 1/3, 1/6, 1/6, 1/3.
  Project project = scene(0, {{"pull", StageKind::static_, 1.0, 60, {}}});
  project.gravity = Vec3::Zero();
  project.materials[0].poisson = 0;
  const double force = 1e6;
  const double parts[4] = {1.0 / 3, 1.0 / 6, 1.0 / 6, 1.0 / 3};
  for (int i = 0; i < 4; ++i) {
    project.constraints.push_back({"B", Vec3(i & 1, i >> 1, 0), {{0.0, 0.0, 0.0}}});
    project.loads.push_back({"B", Vec3(i & 1, i >> 1, 2), Vec3(0, 0, parts[i] * force)});
  }
  const BlockSystem system = blocks({test::box_block("B", Vec3(0, 0, 0), Vec3(1, 1, 2))});
  Simulation simulation(project, system);
  while (!simulation.finished()) simulation.step();
  const double stretch = simulation.frame(0).displacement[7].z();
  EXPECT_NEAR(stretch / (force * 2 / 5e9), 1, 0.02);  // the holding springs give 1 % more
  EXPECT_NEAR(simulation.frame(0).stress[0][2] / force, 1, 1e-3);
}

TEST(Simulation, RepeatsItselfToTheLastBit) {
  const Project project = scene(20, {{"drop", StageKind::dynamic, 0.01, 60, {}}});
  const BlockSystem system = blocks({test::box_block("ground", Vec3(0, 0, -1), Vec3(4, 4, 0), BodyKind::fixed),
                                     test::box_block("B", Vec3(1.1, 1.2, 0.1), Vec3(2.3, 2.1, 1.3))});
  const auto final_positions = [&] {
    Simulation simulation(project, system);
    while (!simulation.finished()) simulation.step();
    return simulation.bodies().nodes.position;
  };
  EXPECT_EQ(final_positions(), final_positions());
}

TEST(Simulation, TwoThreadsGiveTheSameBitsAsOne) {
  const Project project = scene(20, {{"drop", StageKind::dynamic, 0.01, 40, {}}});
  Block cube;
  cube.name = "B";
  cube.mesh = box_mesh(Vec3(1.1, 1.2, 0.1), Vec3(2.3, 2.1, 1.3), 3, 3, 3);
  cube.surface = boundary(cube.mesh);
  ASSERT_GT(cube.mesh.tetrahedra.size(), 100U) << "too few to be worth a second thread";
  const BlockSystem system = blocks({test::box_block("ground", Vec3(0, 0, -1), Vec3(4, 4, 0), BodyKind::fixed), cube});
  const auto final_positions = [&](int threads) {
    const ThreadLimit limit(threads);
    Simulation simulation(project, system);
    while (!simulation.finished()) simulation.step();
    return simulation.bodies().nodes.position;
  };
  EXPECT_EQ(final_positions(1), final_positions(2));
}

TEST(Simulation, MoreThreadsSeeTheContactsOfAPileAsOneDoes) {
  const Project project = scene(20, {{"drop", StageKind::dynamic, 0.01, 10, {}}});
  std::vector<Block> pile = {test::box_block("ground", Vec3(-2, -2, -1), Vec3(6, 6, 0), BodyKind::fixed)};
  for (int i = 0; i < 63; ++i) {
    const Vec3 lower(i % 3 + 0.1 * (i / 9), i / 3 % 3, i / 9 * 1.001);  // each layer a little aside
    pile.push_back(test::box_block("B" + std::to_string(i), lower, lower + Vec3(1, 1, 1), BodyKind::rigid));
  }
  const BlockSystem system = blocks(pile);
  const auto final_positions = [&](int threads) {
    const ThreadLimit limit(threads);
    Simulation simulation(project, system);
    while (!simulation.finished()) simulation.step();
    EXPECT_GT(simulation.work().facet_pairs, 5000 * 10) << "too few to be worth a second thread";
    return simulation.bodies().nodes.position;
  };
  const auto of_one = final_positions(1);
  for (const int threads : {2, 3}) EXPECT_EQ(of_one, final_positions(threads)) << threads;
}

TEST(Simulation, InitialVelocitiesBeginWithTheFirstDynamicStage) {
  Project project = scene(0, {{"wait", StageKind::static_, 0.01, 5, {}}, {"fly", StageKind::dynamic, 0.01, 50, {}}});
  project.gravity = Vec3::Zero();
  project.velocities = {{"B", Vec3(2, 0, 0), Vec3::Zero()}};
  const BlockSystem system = blocks({test::box_block("B", Vec3(0, 0, 0), Vec3(1, 1, 1))});
  Simulation simulation(project, system);
  while (!simulation.finished()) simulation.step();
  EXPECT_NEAR(block_motion(simulation.bodies(), 0).displacement.x(), 2 * 0.5, 1e-12);
}

TEST(Simulation, CohesionHoldsUntilItsStrengthAndThenForGoodNoMore) {
  // A block on a vertical wall, glued by its face of 1 m²: weight 25.5 kN.
  const auto fall_after_a_second = [](double cohesion) {
    Project project = scene(0, {{"hang", StageKind::dynamic, 0.01, 100, {}}});
    project.joints[0].cohesion = cohesion;
    project.joints[0].tensile_strength = 1e6;
    const BlockSystem system = blocks({test::box_block("wall", Vec3(-1, -2, -3), Vec3(0, 3, 3), BodyKind::fixed),
                                       test::box_block("B", Vec3(0, 0, 0), Vec3(1, 1, 1))});
    Simulation simulation(project, system);
    while (!simulation.finished()) simulation.step();
    return -block_motion(simulation.bodies(), 1).displacement.z();
  };
  EXPECT_LT(fall_after_a_second(2e5), 1e-4);
  EXPECT_NEAR(fall_after_a_second(1e4), 0.5 * 9.81, 0.05);
}

TEST(Simulation, StepThatCannotConvergeEndsTheRunAndNamesTheContact) {
  Project project = scene(30, {{"drop", StageKind::dynamic, 0.01, 100, {}}});
  project.solver.open_close_limit = 1;  // too few for any change of state
  const BlockSystem system = blocks({test::box_block("ground", Vec3(0, 0, -1), Vec3(4, 4, 0), BodyKind::fixed),
                                     test::box_block("B", Vec3(1.1, 1.2, 0.1), Vec3(2.3, 2.1, 1.3))});
  Simulation simulation(project, system);
  StepReport last;
  while (!simulation.finished()) last = simulation.step();
  EXPECT_FALSE(simulation.converged());
  EXPECT_GT(last.cuts, 0);
  EXPECT_THAT(simulation.failure(), testing::AllOf(testing::HasSubstr("ground"), testing::HasSubstr("joint J")));
  ASSERT_FALSE(simulation.troubles().empty());
  const ConvergenceTrouble& end = simulation.troubles().back();
  EXPECT_TRUE(end.ended_run);
  EXPECT_EQ(end.cause, TroubleCause::not_converged);
  EXPECT_THAT(end.blocks, testing::ElementsAre("ground", "B"));
  EXPECT_EQ(end.joint, "J");
  EXPECT_NEAR(end.position.z(), 0, 0.02) << "where the cube's foot meets the ground";
  EXPECT_NEAR(end.rest_position.z(), 0.1, 0.02) << "it has fallen by 0.1 m";
  EXPECT_EQ(end.step, last.step);
  EXPECT_THAT(end.advice, testing::HasSubstr("open_close_limit"));
  int cuts = 0;
  for (const ConvergenceTrouble& trouble : simulation.troubles()) cuts += trouble.cuts;
  EXPECT_EQ(cuts, last.cuts);
}

/// Stiff rock that turns by 0.2 rad a step: only the whole tangent leads anywhere.
TEST(Simulation, AStiffBlockThatSpinsConvergesInFewIterations) {
  for (const BodyKind kind : {BodyKind::affine, BodyKind::tetrahedra}) {
    Project project = scene(30, {{"spin", StageKind::dynamic, 2e-3, 100, {}}});
    project.velocities = {{.block = "B", .linear = Vec3(1, 0, 0), .angular = Vec3(60, -40, 80)}};
    Simulation simulation(project,
                          test::block_system({test::box_block("B", Vec3(0, 0, 0), Vec3(0.1, 0.07, 0.05), kind)}));
    int most = 0;
    while (!simulation.finished()) {
      const StepReport report = simulation.step();
      most = std::max(most, report.iterations);
      ASSERT_EQ(report.cuts, 0) << to_string(kind);
    }
    ASSERT_TRUE(simulation.converged()) << simulation.failure();
    EXPECT_LE(most, 12) << to_string(kind);
  }
}

TEST(Simulation, BlockThatFallsFlatConvergesInFewIterationsHoweverLongTheStep) {
  for (const double step : {0.01, 0.1, 1.0}) {
    Project project = scene(20, {{"fall", StageKind::dynamic, step, 2, {}}});
    project.gravity = tilted_gravity(30);
    BlockSystem system = blocks({test::box_block("ground", Vec3(-5, -5, -1), Vec3(20, 5, 0), BodyKind::fixed),
                                 test::box_block("B", Vec3(0, 0, 1e-5), Vec3(1, 1, 0.25))});
    system.blocks[1].body = BodyKind::rigid;
    Simulation simulation(project, system);
    while (!simulation.finished()) {
      const StepReport report = simulation.step();
      EXPECT_LE(report.iterations, 20) << step;
      EXPECT_EQ(report.cuts, 0) << step;
    }
  }
}

/// A bar that falls by 10° to one side and turns by 23° to the other in a step: the corner that comes down was above.
class MissedContactOfABar : public ::testing::Test {
 protected:
  MissedContactOfABar() {
    project_.gravity.setZero();
    project_.velocities = {{.block = "B", .angular = {0, 40, 0}}};
    const Mat3 turn = Eigen::AngleAxisd(-M_PI / 18, Vec3::UnitY()).toRotationMatrix();
    for (Vec3& node : system_.blocks[1].mesh.nodes) node = turn * node + Vec3(0, 0, 0.25);
    system_.blocks[1].body = BodyKind::rigid;
  }
  Project project_ = scene(30, {{"swing", StageKind::dynamic, 0.01, 1, {}}});
  BlockSystem system_ = blocks({test::box_block("ground", Vec3(-3, -3, -1), Vec3(3, 3, 0), BodyKind::fixed),
                                test::box_block("B", Vec3(-1, -0.05, -0.05), Vec3(1, 0.05, 0.05))});
};

TEST_F(MissedContactOfABar, IsTakenIntoTheStep) {
  Simulation simulation(project_, system_);
  const StepReport report = simulation.step();
  ASSERT_TRUE(simulation.converged()) << simulation.failure();
  EXPECT_EQ(report.cuts, 0);
  EXPECT_TRUE(simulation.troubles().empty());
  EXPECT_GT(report.stick + report.slip, 0) << "at the end it touches";
  EXPECT_LT(report.max_relative_penetration, 1e-3);
}

TEST_F(MissedContactOfABar, CutsTheStepThatMayNotTakeItIn) {
  Tolerances tolerances;
  tolerances.solver.step.correction_limit = 0;
  Simulation simulation(project_, system_, tolerances);
  const StepReport report = simulation.step();
  ASSERT_TRUE(simulation.converged()) << simulation.failure();
  ASSERT_FALSE(simulation.troubles().empty());
  EXPECT_EQ(simulation.troubles()[0].cause, TroubleCause::missed_contact);
  EXPECT_THAT(simulation.troubles()[0].blocks, testing::ElementsAre("ground", "B"));
  EXPECT_GT(report.cuts, 0);
}

TEST(Simulation, TellsWhereStepsAreCutAndNothingOfEasyOnes) {
  Project project = scene(30, {{"drop", StageKind::dynamic, 0.01, 30, {}}});
  const BlockSystem system = blocks({test::box_block("ground", Vec3(0, 0, -1), Vec3(4, 4, 0), BodyKind::fixed),
                                     test::box_block("B", Vec3(1.1, 1.2, 0.1), Vec3(2.3, 2.1, 1.3))});
  for (const int limit : {160, 3}) {
    project.solver.open_close_limit = limit;
    Simulation simulation(project, system);
    int hard = 0, cuts = 0;
    while (!simulation.finished()) {
      cuts += simulation.step().cuts;
      for (const ConvergenceTrouble& trouble : simulation.troubles()) {
        ++hard;
        EXPECT_THAT(trouble.blocks, testing::ElementsAre("ground", "B"));
      }
    }
    EXPECT_EQ(hard > 0, limit == 3) << hard;
    EXPECT_EQ(cuts > 0, limit == 3) << cuts;
  }
}

TEST(Simulation, TellsOfStepsThatUseAllRoundsOfCorrection) {
  Project project = scene(30, {{"settle", StageKind::static_, 0.01, 20, {}}});
  project.materials[0].density = 2.6e6;  // heavy, so that one round is not enough
  project.solver.penetration_tolerance = 1e-8;
  const BlockSystem system = test::cube_on_slab();
  for (const int limit : {StepTolerances{}.correction_limit, 1}) {
    Tolerances tolerances;
    tolerances.solver.step.correction_limit = limit;
    Simulation simulation(project, system, tolerances);
    while (!simulation.finished()) simulation.step();
    EXPECT_EQ(simulation.work().correction_limits > 0, limit == 1) << limit;
  }
}

TEST(Simulation, CutsStepsWhoseCorrectionsComeToNoEnd) {
  Project project = scene(30, {{"drop", StageKind::dynamic, 0.01, 20, {}}});
  project.solver.penetration_tolerance = 1e-9;
  const BlockSystem system = blocks({test::box_block("ground", Vec3(0, 0, -1), Vec3(4, 4, 0), BodyKind::fixed),
                                     test::box_block("B", Vec3(1.1, 1.2, 0.01), Vec3(2.3, 2.1, 1.3), BodyKind::rigid)});
  for (const int limit : {StepTolerances{}.correction_limit, 0}) {
    Tolerances tolerances;
    tolerances.solver.step.correction_limit = limit;
    Simulation simulation(project, system, tolerances);
    int cuts = 0;
    while (!simulation.finished()) cuts += simulation.step().cuts;
    EXPECT_TRUE(simulation.converged()) << simulation.failure();
    EXPECT_EQ(cuts > 0, limit == 0) << cuts;
  }
}

TEST(Simulation, TellsOfStepsThatUseAllSweepsOfImpulses) {
  Project project = scene(30, {{"drop", StageKind::dynamic, 0.005, 60, {}}});
  project.joints[0].restitution = 0.5;
  BlockSystem system = blocks({test::box_block("ground", Vec3(0, 0, -1), Vec3(4, 4, 0), BodyKind::fixed),
                               test::box_block("B", Vec3(1, 1, 0.1), Vec3(2, 2, 1.1), BodyKind::rigid)});
  for (const int limit : {ImpactTolerances{}.sweep_limit, 1}) {
    Tolerances tolerances;
    tolerances.solver.impact.sweep_limit = limit;
    Simulation simulation(project, system, tolerances);
    while (!simulation.finished()) simulation.step();
    EXPECT_EQ(simulation.work().impact_sweep_limits > 0, limit == 1) << limit;
  }
}

/// A box of 1.4 mm that flies at the ground by many of its sizes a step.
struct Grit {
  Project project = scene(30, {{"fly", StageKind::dynamic, 0.0115, 3, {}}});
  BlockSystem system;
  Grit(BodyKind kind, double angle, double spin, double speed) {
    project.gravity.setZero();
    project.velocities = {{"B", Vec3(0.1 * speed, 0, -speed), spin * Vec3(0, 70, 10)}};
    Block body = test::box_block("B", {0, 0, 0}, {0.0014, 0.00098, 0.00084}, kind);
    const Mat3 turn = Eigen::AngleAxisd(angle, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    for (Vec3& node : body.mesh.nodes) node = turn * node + Vec3(-1, 0, 0.15);
    system = blocks({test::box_block("ground", Vec3(-3, -3, -1), Vec3(3, 3, 0), BodyKind::fixed), std::move(body)});
  }
};

TEST(Simulation, CutsAStepBelowItsShortestWhereABodyFliesByManyOfItsSizes) {
  for (const BodyKind kind : {BodyKind::rigid, BodyKind::affine}) {
    const Grit grit(kind, 1.9, 0.2, 100);
    Simulation simulation(grit.project, grit.system);
    int cuts = 0;
    while (!simulation.finished()) cuts += simulation.step().cuts;
    EXPECT_TRUE(simulation.converged()) << simulation.failure();
    EXPECT_GT(cuts, 4);
    for (int n = 0; n < simulation.bodies().bodies[1].node_count; ++n)
      EXPECT_GT(simulation.bodies().nodes.position[simulation.bodies().bodies[1].first_node + n].z(), -1e-4);

    Tolerances coarse;
    coarse.solver.step.shortest_way = 1e9;
    Simulation given_up(grit.project, grit.system, coarse);
    while (!given_up.finished()) given_up.step();
    EXPECT_FALSE(given_up.converged()) << "a hundredth of the step is too long";
  }
}

/// An iterate may strain a block so far that its inertia is lost in the rounding of its stiffness.
TEST(Simulation, CutsAStepWhoseIterateIsLost) {
  const Grit grit(BodyKind::affine, 1.1, 0.2, 20);
  Simulation simulation(grit.project, grit.system);
  int cuts = 0;
  while (!simulation.finished()) cuts += simulation.step().cuts;
  EXPECT_TRUE(simulation.converged()) << simulation.failure();
  EXPECT_GT(cuts, 0);
}

}  // namespace
}  // namespace talus
