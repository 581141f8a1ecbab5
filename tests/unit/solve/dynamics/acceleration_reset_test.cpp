#include "solve/dynamics/acceleration_reset.hpp"

#include <gtest/gtest.h>

#include "bodies/nodal_motion.hpp"
#include "support/solver_scenes.hpp"

namespace talus {
namespace {

constexpr double length = 0.01;  // s

/// A rigid cube that moves along x with an acceleration, and comes to another in a step of Newmark's method.
class AccelerationResetTest : public testing::Test {
 protected:
  AccelerationResetTest()
      : system_(test::cube_on_slab()), set_(project(), rigid(system_)), reset_(set_, {1, 1}, tolerances_) {
    step_.length = length;
    increment_ = Increment::Zero(set_.unknowns());
  }
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
    set_.nodes.velocity[centre()] = {1, 0, 0};
    reset_.begin_step(set_);
    step_to(after);
  }
  /// Another step, which converges to this acceleration at its end; the ground pushes with `push` then [N].
  void step_to(double after, double push = 0) {
    const double beta = constant() ? 0.5 : step_.integration.beta;
    const Vec3 displacement = length * set_.nodes.velocity[centre()] +
                              length * length * ((0.5 - beta) * acceleration() + beta * Vec3(after, 0, 0));
    increment_.segment<3>(3 * set_.nodes.dof_block[centre()]) = displacement;
    ContactSet contacts;
    ContactPoint point{};
    point.bodies[1] = 1;
    point.normal = -Vec3::UnitZ();
    contacts.points = {point};
    reset_.note_contact_forces(set_, contacts, {{.normal_force = push}});
    reset_.look_at(set_, step_, increment_);
    acceleration() = {after, 0, 0};
    reset_.drop(set_);
    reset_.begin_step(set_);
  }

  const AccelerationResetTolerances tolerances_;
  BlockSystem system_;
  BodySet set_;
  AccelerationReset reset_;
  StepContext step_;
  Increment increment_;
};

TEST_F(AccelerationResetTest, RigidBodiesBeginAStageWithTheAccelerationTheyEndWith) {
  reset_.begin_stage(set_);
  reset_.begin_step(set_);
  EXPECT_TRUE(constant());
}

TEST_F(AccelerationResetTest, GoesOnWithTheEndWhereTheAccelerationStaysOrDiesAway) {
  for (const double after : {10.0, 10 * (1 + 0.9 * tolerances_.sudden_change), 7.0, 1.0}) {
    begin(10);
    step_to(after);
    EXPECT_TRUE(constant()) << after;
    EXPECT_EQ(acceleration(), Vec3(Vec3::Zero())) << "no step has paid for it";
  }
}

/// Newmark's method damps infinitely stiff modes by −1/3 a step.
TEST_F(AccelerationResetTest, DampsAStiffContactThatSwings) {
  begin(300);
  step_to(-300);
  EXPECT_FALSE(constant());
  step_to(-300.0 / 3);
  EXPECT_TRUE(constant()) << "it dies away";
  begin(300);
  for (const double after : {-300.0, 100.0, -100.0 / 3}) step_to(after);
  EXPECT_FALSE(constant());
  EXPECT_EQ(acceleration().x(), -100.0 / 3) << "the step has paid for it";
}

/// What it had at the start is out of account: v₀Δ + a₁Δ²/2, exact for a constant force.
TEST_F(AccelerationResetTest, BeginsWithTheAccelerationItEndsWith) {
  begin(300);
  increment_.segment<3>(3 * set_.nodes.dof_block[centre()]) = Vec3(length + 0.5 * 7 * length * length, 0, 0);
  EXPECT_NEAR(end_acceleration(set_, step_, centre(), increment_).x(), 7, 1e-9);
}

TEST_F(AccelerationResetTest, GoesOnWithoutAnAccelerationAfterABlow) {
  const double visible = tolerances_.visible_displacement / (length * length);
  for (const double left : {0.9 * visible, 1.1 * visible, 300.0}) {
    begin(10);
    step_to(left, 1e6);
    EXPECT_EQ(acceleration(), Vec3(Vec3::Zero())) << left;
    EXPECT_EQ(constant(), left > visible) << left << ": it moves by what the blow left it with";
  }
}

}  // namespace
}  // namespace talus
