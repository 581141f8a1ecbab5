#include "solve/simulation.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "bodies/block_motion.hpp"
#include "support/small_scenes.hpp"

namespace talus {
namespace {

Project scene(double friction_angle, std::vector<Stage> stages) {
  Project project;
  project.name = "scene";
  project.materials = {{"rock", 2600, 5e9, 0.24}};
  project.joints = {{"J", friction_angle, 0, 0, {}, {}, {}}};
  project.default_joint = "J";
  project.stages = std::move(stages);
  return project;
}

BlockSystem blocks(std::vector<Block> list) {
  BlockSystem system;
  system.blocks = std::move(list);
  system.joint_names = {"J"};
  system.solids_volume = 1;
  return system;
}

/// Gravity of a plane that dips by `dip` degrees towards +x, in the plane's own axes.
Vec3 tilted_gravity(double dip) { return 9.81 * Vec3(std::sin(dip * M_PI / 180), 0, -std::cos(dip * M_PI / 180)); }

TEST(Simulation, free_fall_is_exact_for_the_constant_acceleration_integrator) {
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

}  // namespace
}  // namespace talus
