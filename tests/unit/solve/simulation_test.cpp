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

TEST(Simulation, free_fall_is_exact) {
  const Project project = scene(30, {{"fall", StageKind::dynamic, 0.01, 100, {}}});
  const BlockSystem system = blocks({test::box_block("B", Vec3(0, 0, 10), Vec3(1, 1, 11))});
  Simulation simulation(project, system);
  while (!simulation.finished()) simulation.step();
  const BlockMotion motion = block_motion(simulation.bodies(), 0);
  EXPECT_NEAR(motion.displacement.z() / (-0.5 * 9.81), 1, 1e-10);
  EXPECT_NEAR(motion.velocity.z() / -9.81, 1, 1e-10);
}

TEST(Simulation, a_block_on_a_plane_slides_at_the_acceleration_of_coulomb) {
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

TEST(Simulation, a_block_below_its_friction_angle_does_not_creep) {
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

TEST(Simulation, a_block_dropped_on_another_lands_and_rests_without_gaining_energy) {
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

TEST(Simulation, a_bar_pulled_by_a_point_load_and_held_at_its_foot_stretches_as_hooke_says) {
  // One column of tetrahedra, held at every node of the foot, pulled at every node of the top: uniform stress needs
  // consistent nodal forces, which for Kuhn's split of the top square are 1/3, 1/6, 1/6, 1/3.
  Project project = scene(0, {{"pull", StageKind::static_, 1.0, 60, {}}});
  project.gravity = Vec3::Zero();
  project.materials[0].poisson = 0;
  const double force = 1e6;
  const double shares[4] = {1.0 / 3, 1.0 / 6, 1.0 / 6, 1.0 / 3};
  for (int i = 0; i < 4; ++i) {
    project.constraints.push_back({"B", Vec3(i & 1, i >> 1, 0), {{0.0, 0.0, 0.0}}});
    project.loads.push_back({"B", Vec3(i & 1, i >> 1, 2), Vec3(0, 0, shares[i] * force)});
  }
  const BlockSystem system = blocks({test::box_block("B", Vec3(0, 0, 0), Vec3(1, 1, 2))});
  Simulation simulation(project, system);
  while (!simulation.finished()) simulation.step();
  const double stretch = simulation.frame(0).displacement[7].z();
  EXPECT_NEAR(stretch / (force * 2 / 5e9), 1, 0.02);  // the holding springs give 1 % more
  EXPECT_NEAR(simulation.frame(0).stress[0][2] / force, 1, 1e-3);
}

TEST(Simulation, repeats_itself_to_the_last_bit) {
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

TEST(Simulation, two_threads_give_the_same_bits_as_one) {
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

TEST(Simulation, initial_velocities_begin_with_the_first_dynamic_stage) {
  Project project = scene(0, {{"wait", StageKind::static_, 0.01, 5, {}}, {"fly", StageKind::dynamic, 0.01, 50, {}}});
  project.gravity = Vec3::Zero();
  project.velocities = {{"B", Vec3(2, 0, 0), Vec3::Zero()}};
  const BlockSystem system = blocks({test::box_block("B", Vec3(0, 0, 0), Vec3(1, 1, 1))});
  Simulation simulation(project, system);
  while (!simulation.finished()) simulation.step();
  EXPECT_NEAR(block_motion(simulation.bodies(), 0).displacement.x(), 2 * 0.5, 1e-12);
}

TEST(Simulation, cohesion_holds_until_its_strength_and_then_for_good_no_more) {
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

TEST(Simulation, a_step_that_cannot_settle_ends_the_run_with_the_contact_named) {
  Project project = scene(30, {{"drop", StageKind::dynamic, 0.01, 100, {}}});
  project.solver.open_close_limit = 2;  // too few for any change of state
  const BlockSystem system = blocks({test::box_block("ground", Vec3(0, 0, -1), Vec3(4, 4, 0), BodyKind::fixed),
                                     test::box_block("B", Vec3(1.1, 1.2, 0.1), Vec3(2.3, 2.1, 1.3))});
  Simulation simulation(project, system);
  StepReport last;
  while (!simulation.finished()) last = simulation.step();
  EXPECT_FALSE(simulation.converged());
  EXPECT_GT(last.cuts, 0);
  EXPECT_THAT(simulation.failure(), testing::AllOf(testing::HasSubstr("ground"), testing::HasSubstr("joint J")));
  ASSERT_FALSE(simulation.struggles().empty());
  const Struggle& end = simulation.struggles().back();
  EXPECT_TRUE(end.ended_run);
  EXPECT_EQ(end.cause, StruggleCause::not_settled);
  EXPECT_THAT(end.blocks, testing::ElementsAre("ground", "B"));
  EXPECT_EQ(end.joint, "J");
  EXPECT_NEAR(end.position.z(), 0, 0.02) << "where the cube's foot meets the ground";
  EXPECT_NEAR(end.rest_position.z(), 0.1, 0.02) << "it has fallen by 0.1 m";
  EXPECT_EQ(end.step, last.step);
  EXPECT_THAT(end.advice, testing::HasSubstr("open_close_limit"));
  int cuts = 0;
  for (const Struggle& struggle : simulation.struggles()) cuts += struggle.cuts;
  EXPECT_EQ(cuts, last.cuts);
}

TEST(Simulation, a_block_that_falls_flat_settles_in_few_iterations_however_long_the_step) {
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

TEST(Simulation, a_step_is_cut_where_blocks_turn_into_each_other_unforeseen) {
  Project project = scene(30, {{"swing", StageKind::dynamic, 0.01, 1, {}}});
  project.gravity.setZero();
  project.velocities = {{.block = "B", .angular = {0, 40, 0}}};
  // A bar that falls by 10° to one side and turns by 23° to the other in a step: the corner that comes down was above.
  BlockSystem system = blocks({test::box_block("ground", Vec3(-3, -3, -1), Vec3(3, 3, 0), BodyKind::fixed),
                               test::box_block("B", Vec3(-1, -0.05, -0.05), Vec3(1, 0.05, 0.05))});
  const Mat3 turn = Eigen::AngleAxisd(-M_PI / 18, Vec3::UnitY()).toRotationMatrix();
  for (Vec3& node : system.blocks[1].mesh.nodes) node = turn * node + Vec3(0, 0, 0.25);
  system.blocks[1].body = BodyKind::rigid;
  Simulation simulation(project, system);
  const StepReport report = simulation.step();
  ASSERT_TRUE(simulation.converged()) << simulation.failure();
  ASSERT_FALSE(simulation.struggles().empty());
  EXPECT_EQ(simulation.struggles()[0].cause, StruggleCause::found_late);
  EXPECT_THAT(simulation.struggles()[0].blocks, testing::ElementsAre("ground", "B"));
  EXPECT_GT(report.cuts, 0);
}

TEST(Simulation, steps_that_are_cut_and_settle_say_where_and_easy_ones_say_nothing) {
  Project project = scene(30, {{"drop", StageKind::dynamic, 0.01, 30, {}}});
  const BlockSystem system = blocks({test::box_block("ground", Vec3(0, 0, -1), Vec3(4, 4, 0), BodyKind::fixed),
                                     test::box_block("B", Vec3(1.1, 1.2, 0.1), Vec3(2.3, 2.1, 1.3))});
  for (const int limit : {160, 3}) {
    project.solver.open_close_limit = limit;
    Simulation simulation(project, system);
    int hard = 0, cuts = 0;
    while (!simulation.finished()) {
      cuts += simulation.step().cuts;
      for (const Struggle& struggle : simulation.struggles()) {
        ++hard;
        EXPECT_THAT(struggle.blocks, testing::ElementsAre("ground", "B"));
      }
    }
    EXPECT_EQ(hard > 0, limit == 3) << hard;
    EXPECT_EQ(cuts > 0, limit == 3) << cuts;
  }
}

}  // namespace
}  // namespace talus
