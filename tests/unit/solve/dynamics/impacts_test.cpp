// The law of impact: how blocks part, and what friction does meanwhile.
#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <random>

#include "mesh/structured_mesh.hpp"
#include "support/solver_scenes.hpp"

namespace talus {
namespace {

constexpr double pi_degrees = 180 / M_PI;

struct Scene {
  Project project;
  BlockSystem system;
};

/// A rigid plate of 2 m × 2 m × 0.02 m at this height [m] above a slab, with this velocity [m/s]. It is so flat that
/// friction hardly turns it.
Scene plate(double height, const Vec3& velocity, std::optional<double> restitution, double friction, double step) {
  Scene scene;
  scene.project = test::rock_project(std::atan(friction) * pi_degrees, {{"fly", StageKind::dynamic, step, 0, {}}});
  scene.project.joints[0].restitution = restitution;
  scene.project.gravity.setZero();
  scene.project.solver.tolerance = reference_tolerance.value;  // impulses are found as exactly
  scene.project.velocities = {{.block = "plate", .linear = velocity}};
  scene.project.stages[0].steps = static_cast<int>(std::ceil(2 * height / -velocity.z() / step)) + 4;
  scene.system =
      test::block_system({test::box_block("slab", Vec3(-9, -9, -1), Vec3(9, 9, 0), BodyKind::fixed),
                          test::box_block("plate", Vec3(0, 0, height), Vec3(2, 2, height + 0.02), BodyKind::rigid)});
  return scene;
}

Vec3 velocity_at_the_end(const Scene& scene) {
  Simulation simulation(scene.project, scene.system);
  StepReport report;
  double moved = 0;
  while (!simulation.finished()) {
    report = simulation.step();
    moved = std::max(moved, report.energy.kinetic);
  }
  EXPECT_TRUE(simulation.converged()) << simulation.failure();
  EXPECT_LT(std::abs(report.energy.remainder), 1e-8 * moved) << "the ledger";
  return block_motion(simulation.bodies(), 1).velocity;
}

TEST(Impacts, BlockLeavesAtTheRestitutedSpeedWhereverInTheStepItLands) {
  for (const double restitution : {0.0, 0.3, 0.8, 1.0})
    for (const double height : {0.0101, 0.0134, 0.0150, 0.0199})
      EXPECT_NEAR(velocity_at_the_end(plate(height, Vec3(0, 0, -2), restitution, 0, 1e-3)).z(), 2 * restitution, 1e-3)
          << restitution << ", from " << height;
}

TEST(Impacts, WithoutARestitutionSpringsTooStiffForTheStepThrowNothingBack) {
  for (const double height : {0.0101, 0.0134, 0.0150, 0.0199})
    EXPECT_NEAR(velocity_at_the_end(plate(height, Vec3(0, 0, -2), {}, 0, 1e-3)).z(), 0, 1e-3) << "from " << height;
}

// On springs with ω Δ = 0.1 contact lasts 31 steps; forces at their ends damp it by ωΔ/4, to exp(−π ωΔ/4).
TEST(Impacts, WithoutARestitutionBlocksThatDeformAreThrownBackLessThanBySprings) {
  for (const BodyKind body : {BodyKind::affine, BodyKind::tetrahedra})
    for (const double height : {0.0101, 0.0134, 0.0150, 0.0199}) {
      Scene scene = plate(height, Vec3(0, 0, -2), {}, 0, 1e-3);
      scene.system.blocks.back().body = body;
      const double by_law = velocity_at_the_end(scene).z();
      scene.project.solver.effects.rebound = Switch::off;
      EXPECT_LT(by_law, 0.8 * velocity_at_the_end(scene).z()) << to_string(body) << ", from " << height;
    }
}

TEST(Impacts, WithoutARestitutionSpringsThatTheStepFollowsThrowBackWhatTheyTook) {
  const double step = 1e-3, speed = 0.2, area = 4, mass = 2600 * area * 0.02;
  for (const double height : {0.00101, 0.00112, 0.00119}) {
    Scene scene = plate(height, Vec3(0, 0, -speed), {}, 0, step);
    scene.project.joints[0].normal_stiffness = mass * std::pow(0.1 / step, 2) / area;
    scene.project.stages[0].steps = 60;
    EXPECT_NEAR(velocity_at_the_end(scene).z(), speed * std::exp(-M_PI * 0.1 / 4), 0.01 * speed) << "from " << height;
  }
}

TEST(Impacts, StepDoesNotMatter) {
  for (const double step : {1e-2, 1e-3, 1e-4})
    EXPECT_NEAR(velocity_at_the_end(plate(0.0131, Vec3(0, 0, -1), 0.5, 0, step)).z(), 0.5, 1e-3) << step;
}

TEST(Impacts, FrictionTakesCoulombsPartOfTheImpulse) {
  const double friction = 0.25, restitution = 0.4;
  const Vec3 after = velocity_at_the_end(plate(0.0131, Vec3(3, 0, -2), restitution, friction, 1e-3));
  EXPECT_NEAR(after.z(), 2 * restitution, 0.01);
  EXPECT_NEAR(after.x(), 3 - friction * 2 * (1 + restitution), 0.01) << "Coulomb's law for impulses";
}

TEST(Impacts, WhatSticksIsNotThrownBack) {
  const Vec3 after = velocity_at_the_end(plate(0.0131, Vec3(0.1, 0, -2), 0, 1, 1e-3));
  EXPECT_NEAR(after.x(), 0, 1e-6);
}

/// A brick, turned at random, that falls on a slab and spins.
Scene tumbling_brick(std::mt19937& random, double restitution, BodyKind body) {
  std::normal_distribution<double> normal;
  const auto drawn = [&] { return Vec3(normal(random), normal(random), normal(random)); };
  const Mat3 turn = Eigen::AngleAxisd(normal(random), drawn().normalized()).toRotationMatrix();
  Scene scene;
  scene.project = test::rock_project(25, {{"fall", StageKind::dynamic, 2e-3, 400, {}}});
  scene.project.joints[0].restitution = restitution;
  scene.project.velocities = {{.block = "brick", .linear = Vec3(1, 0, 0), .angular = 2 * drawn()}};
  Block brick = test::box_block("brick", Vec3(-0.3, -0.2, -0.1), Vec3(0.3, 0.2, 0.1), body);
  for (Vec3& node : brick.mesh.nodes) node = turn * node + Vec3(0, 0, 0.8);
  scene.system = test::block_system({test::box_block("slab", Vec3(-9, -9, -1), Vec3(9, 9, 0), BodyKind::fixed), brick});
  return scene;
}

TEST(Impacts, NoEnergyIsMadeHoweverABrickLands) {
  std::mt19937 random{3};
  for (int i = 0; i < 32; ++i) {
    const Scene scene = tumbling_brick(random, i % 2 ? 1 : 0.9, i % 4 < 2 ? BodyKind::rigid : BodyKind::affine);
    Simulation simulation(scene.project, scene.system);
    double before = std::numeric_limits<double>::infinity(), most = 0, growth = 0;
    while (!simulation.finished()) {
      const EnergyLedger energy = simulation.step().energy;
      const double now =
          energy.kinetic + energy.elastic + energy.potential + energy.contact + energy.integration_reserve;
      growth = std::max(growth, now - before);
      most = std::max(most, energy.kinetic);
      before = now;
    }
    EXPECT_TRUE(simulation.converged());
    EXPECT_LT(growth, 1e-6 * most) << "brick " << i;
    EXPECT_GT(most, 0);
  }
}

TEST(Impacts, BlockAtRestStaysAtRestAndFeelsItsWeight) {
  Scene scene;
  scene.project = test::rock_project(30, {{"stand", StageKind::dynamic, 0.01, 200, {}}});
  scene.project.joints[0].restitution = 0;
  scene.project.solver.sleep_tolerance = 0;
  scene.system = test::cube_on_slab();
  Simulation simulation(scene.project, scene.system);
  for (int i = 0; i < 100; ++i) simulation.step();
  const Vec3 settled = block_motion(simulation.bodies(), 1).displacement;
  while (!simulation.finished()) simulation.step();
  double push = 0;
  for (const ContactSample& contact : simulation.contacts()) push += contact.normal_force;
  EXPECT_NEAR(push, 2600 * 9.81, 1e-3 * 2600 * 9.81);
  EXPECT_LT((block_motion(simulation.bodies(), 1).displacement - settled).norm(), 1e-9);
}

/// A slab that starts at once at v gives a block of mass m that lies on it m v², of which half is lost in the blow.
TEST(Impacts, ABaseThatStartsGivesWhatTheBlockGetsAndWhatTheBlowTakes) {
  constexpr double speed = 0.5, mass = 2600 * 0.08;
  Scene scene = plate(0, Vec3::Zero(), {}, 0.5, 2e-3);
  scene.project.velocities.clear();
  scene.project.stages[0].steps = 100;
  scene.project.constraints = {{"slab", std::nullopt, {0, 0, 0}, {{0, Vec3::Zero()}, {1, Vec3(0, 0, speed)}}}};
  Simulation simulation(scene.project, scene.system);
  StepReport report;
  double highest = 0, least_damping = 0;
  while (!simulation.finished()) {
    report = simulation.step();
    const EnergyLedger& energy = report.energy;
    const double held = energy.kinetic + energy.contact - energy.constraint_work;
    highest = std::max(highest, held);
    least_damping = std::min(least_damping, energy.damping_dissipated);
  }
  ASSERT_TRUE(simulation.converged()) << simulation.failure();
  EXPECT_NEAR(report.energy.kinetic, mass * speed * speed / 2, 1e-2 * mass * speed * speed);
  EXPECT_NEAR(report.energy.constraint_work, mass * speed * speed, 2e-2 * mass * speed * speed);
  EXPECT_GE(least_damping, 0) << "a blow takes energy";
  EXPECT_LT(highest, 1e-6 * mass * speed * speed) << "nothing is made";
}

}  // namespace
}  // namespace talus
