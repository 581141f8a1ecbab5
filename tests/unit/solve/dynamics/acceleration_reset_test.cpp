#include "solve/dynamics/acceleration_reset.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "bodies/nodal_motion.hpp"
#include "solve/simulation.hpp"
#include "support/solver_scenes.hpp"

namespace talus {
namespace {

constexpr double length = 0.01;  // s

/// A rigid cube that moves along x with an acceleration, and comes to another in a step of Newmark's method.
class AccelerationResetTest : public testing::Test {
 protected:
  AccelerationResetTest() : system_(test::cube_on_slab()), set_(project(), rigid(system_)), reset_(set_, tolerances_) {}
  static Project project() { return test::rock_project(30, {}); }
  static BlockSystem& rigid(BlockSystem& system) {
    system.blocks[1].body = BodyKind::rigid;
    return system;
  }
  int centre() const { return set_.rigid[set_.bodies[1].rigid].centre; }
  Vec3& acceleration() { return set_.nodes.acceleration[centre()]; }

  bool constant() const { return set_.bodies[1].constant_acceleration; }

  /// The stage has begun, and its first step ended with this acceleration.
  void begin(double after) {
    reset_.begin_stage(set_);
    reset_.begin_step(set_);
    step_to(after);
  }
  /// Another step, which ends with this acceleration; the ground pushes with `push` then [N], and impacts change the
  /// velocity by `impact` [m/s].
  void step_to(double after, double push = 0, double impact = 0) {
    ContactSet contacts;
    ContactPoint point{};
    point.bodies[1] = 1;
    point.normal = -Vec3::UnitZ();
    contacts.points = {point};
    reset_.note_start(set_, contacts, {{.normal_force = push}});
    acceleration() = {after, 0, 0};
    set_.nodes.velocity[centre()] += Vec3(length * after + impact, 0, 0);
    reset_.drop(set_, free_flight_);
    reset_.end_step(set_, length, free_flight_);
    reset_.begin_step(set_);
  }

  const AccelerationResetTolerances tolerances_;
  BlockSystem system_;
  BodySet set_;
  AccelerationReset reset_;
  FreeFlight free_flight_{set_};
};

TEST_F(AccelerationResetTest, RigidBodiesBeginAStageWithTheAccelerationTheyEndWith) {
  reset_.begin_stage(set_);
  reset_.begin_step(set_);
  EXPECT_TRUE(constant());
}

TEST_F(AccelerationResetTest, GoesOnWithTheEndWhereTheAccelerationGrowsOrDiesAway) {
  for (const double factor : {3.0, 1.0, 0.3}) {
    begin(10);
    for (double after = 10, step = 0; step < 5; ++step) step_to(after *= factor);
    EXPECT_TRUE(constant()) << factor;
    EXPECT_EQ(acceleration(), Vec3(Vec3::Zero())) << "no step has paid for it";
  }
}

/// A block that sticks to a shaken table: its friction must not ring about what the table asks of it.
TEST_F(AccelerationResetTest, DampsWhatSwingsAboutAnAcceleration) {
  for (const double swing : {0.9 * tolerances_.swing, 1.1 * tolerances_.swing}) {
    begin(10);
    for (const double after : {10 * (1 + swing), 10.0, 10 * (1 + swing)}) step_to(after);
    EXPECT_EQ(constant(), swing < tolerances_.swing) << swing;
  }
}

/// Newmark's method damps infinitely stiff modes by −1/3 a step.
TEST_F(AccelerationResetTest, DampsAStiffContactThatSwings) {
  begin(300);
  step_to(-300);
  EXPECT_TRUE(constant()) << "it may go on growing";
  step_to(300);
  EXPECT_FALSE(constant()) << "it swings";
  for (const double after : {-100.0, 100.0 / 3}) step_to(after);
  EXPECT_FALSE(constant());
  EXPECT_EQ(acceleration().x(), 100.0 / 3) << "the step has paid for it";
}

/// A push that stays the same but for rounding, and then falls.
TEST_F(AccelerationResetTest, ChangesByRoundingAreNoSwing) {
  begin(10);
  for (const double after : {10 * (1 + 1e-15), 5.0}) step_to(after);
  EXPECT_TRUE(constant());
}

/// What an impact takes back at the end of the step is no acceleration.
TEST_F(AccelerationResetTest, ImpactsCount) {
  begin(10);
  for (const double swing : {5.0, -5.0, 5.0}) step_to(10 + swing, 0, -swing * length);
  EXPECT_TRUE(constant());
}

/// What it had at the start is out of account: v₀Δ + a₁Δ²/2, exact for a constant force.
TEST_F(AccelerationResetTest, BeginsWithTheAccelerationItEndsWith) {
  begin(300);
  StepContext step;
  step.length = length;
  Increment increment = Increment::Zero(set_.unknowns());
  increment.segment<3>(3 * set_.nodes.dof_block[centre()]) =
      length * set_.nodes.velocity[centre()] + Vec3(0.5 * 7 * length * length, 0, 0);
  EXPECT_NEAR(end_acceleration(set_, step, centre(), increment).x(), 7, 1e-9);
}

TEST_F(AccelerationResetTest, GoesOnWithoutAnAccelerationAfterABlow) {
  begin(300);
  for (const double after : {-300.0, 300.0}) step_to(after);
  ASSERT_FALSE(constant());
  step_to(-100, 1e6);
  EXPECT_EQ(acceleration(), Vec3(Vec3::Zero()));
}

/// Friction must not ring about what the table asks of the block, and let it slip before its time.
TEST(AccelerationReset, ABlockMovesWithTheShakenTableItSticksTo) {
  const double step = 0.002, acceleration = 3, omega = 2 * M_PI;
  Project project = test::rock_project(
      45, {{"settle", StageKind::static_, step, 20, {}}, {"shake", StageKind::dynamic, step, 500, {}}});
  Constraint base;
  base.block = "ground";
  for (int k = 0; k <= 500; ++k) {
    const double t = k * step;
    base.table.push_back({20 * step + t, Vec3(acceleration / omega * (t - std::sin(omega * t) / omega), 0, 0)});
  }
  project.constraints = {base};
  BlockSystem system = test::cube_on_slab();
  system.blocks[1].body = BodyKind::rigid;
  Simulation simulation(project, system);
  double farthest_off = 0;
  while (!simulation.finished()) {
    simulation.step();
    const double t = simulation.time() - 20 * step;
    const double table = t > 0 ? acceleration / omega * (1 - std::cos(omega * t)) : 0;
    farthest_off = std::max(farthest_off, std::abs(block_motion(simulation.bodies(), 1).velocity.x() - table));
  }
  ASSERT_TRUE(simulation.converged());
  EXPECT_LT(farthest_off, 0.1 * acceleration * step);
}

}  // namespace
}  // namespace talus
