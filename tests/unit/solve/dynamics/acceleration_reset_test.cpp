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

  /// Another step, with this velocity and acceleration at its start.
  void begin(double speed, double before) {
    reset_.begin_stage(set_);
    begin_next(speed, before);
  }
  void begin_next(double speed, double before) {
    reset_.note_contact_forces(set_, {}, {});
    set_.nodes.velocity[centre()] = {speed, 0, 0};
    acceleration() = {before, 0, 0};
    reset_.begin_step(set_);
  }
  void move_to(double after) {
    const double beta = constant() ? 0.5 : step_.integration.beta;
    const Vec3 displacement = length * set_.nodes.velocity[centre()] +
                              length * length * ((0.5 - beta) * acceleration() + beta * Vec3(after, 0, 0));
    increment_.segment<3>(3 * set_.nodes.dof_block[centre()]) = displacement;
  }
  /// The step converges to this acceleration at its end; whether that changes the one at its start.
  bool ends_with(double after) {
    move_to(after);
    return reset_.correct(set_, step_, increment_);
  }
  /// Energy that such a step returns to the cube, of its kinetic energy.
  double returned_energy(double after) {
    const double before = acceleration().x(), speed = set_.nodes.velocity[centre()].x();
    return (step_.integration.beta - 0.5) * length * length * after * (before - after) / (0.5 * speed * speed);
  }
  /// The ground pushes the cube as it never did before: it has taken a blow, and ends the step with this acceleration.
  void strike(double after) {
    ContactSet contacts;
    ContactPoint point{};
    point.bodies[1] = 1;
    point.normal = -Vec3::UnitZ();
    contacts.points = {point};
    move_to(after);
    reset_.note_contact_forces(set_, contacts, {{.normal_force = 1e6}});
    reset_.find_blows(set_, step_, increment_);
    reset_.drop_after_blows(set_);
    reset_.begin_step(set_);
  }

  const AccelerationResetTolerances tolerances_;
  BlockSystem system_;
  BodySet set_;
  AccelerationReset reset_;
  StepContext step_;
  Increment increment_;
};

TEST_F(AccelerationResetTest, KeepsAnAccelerationThatGoesOnOrGrows) {
  begin(1, 10);
  for (const double after : {10.0, 30.0}) EXPECT_FALSE(ends_with(after));
  EXPECT_FALSE(constant());
}

TEST_F(AccelerationResetTest, ResetsAnAccelerationThatHasEnded) {
  for (const double left : {0.9 * tolerances_.acceleration_left, 0.0, -0.1}) {
    begin(1, 10);
    EXPECT_TRUE(ends_with(10 * left)) << left;
    EXPECT_TRUE(constant());
    EXPECT_FALSE(ends_with(10 * left)) << "once a step";
    begin_next(1, 10 * left);
    EXPECT_FALSE(constant()) << "in that step alone";
  }
}

/// Newmark's method damps infinitely stiff modes by −1/3 a step, which is no blow.
TEST_F(AccelerationResetTest, KeepsTheAccelerationOfAStiffContactThatSwings) {
  begin(1, 300);
  EXPECT_FALSE(ends_with(-300.0 / 3));
}

TEST_F(AccelerationResetTest, ReturnsNoMoreEnergyThanTolerated) {
  int resets = 0, kept = 0;
  for (const double speed : {0.02, 0.2, 1.0, 20.0})
    for (const double left : {0.75, 0.85, 0.95, 0.999}) {
      begin(speed, 300);
      const bool too_much = returned_energy(300 * left) > tolerances_.returned_energy;
      (too_much ? resets : kept)++;
      EXPECT_EQ(ends_with(300 * left), too_much) << speed << " m/s, " << left;
      EXPECT_EQ(constant(), too_much);
    }
  EXPECT_GT(resets, 0);
  EXPECT_GT(kept, 0);
}

/// What it had at the start is out of account: v₀Δ + a₁Δ²/2, exact for a constant force.
TEST_F(AccelerationResetTest, BeginsWithTheAccelerationItEndsWith) {
  begin(2, 300);
  ASSERT_TRUE(ends_with(0));
  increment_.segment<3>(3 * set_.nodes.dof_block[centre()]) = Vec3(2 * length + 0.5 * 7 * length * length, 0, 0);
  EXPECT_NEAR(end_acceleration(set_, step_, centre(), increment_).x(), 7, 1e-9);
}

TEST_F(AccelerationResetTest, GivesABodyAfterABlowTheAccelerationItEndsWith) {
  begin(1, 300);
  strike(300);
  EXPECT_EQ(acceleration(), Vec3(Vec3::Zero()));
  EXPECT_TRUE(constant()) << "it moves by what the blow left it with";
  EXPECT_FALSE(ends_with(5));
  EXPECT_TRUE(constant());
}

TEST_F(AccelerationResetTest, SeesThatABodyMovesAfterABlow) {
  const double visible = tolerances_.visible_displacement / (length * length);
  begin(1, 300);
  strike(0.9 * visible);
  EXPECT_FALSE(constant());
  EXPECT_FALSE(ends_with(0.9 * visible));
  EXPECT_TRUE(ends_with(1.1 * visible));
  EXPECT_TRUE(constant());
}

TEST_F(AccelerationResetTest, DoesNotLetTheRestOfABlowThrowABodyBack) {
  begin(1, 300);
  strike(300);
  EXPECT_TRUE(ends_with(-1.5 * 1 / length)) << "more than stops it in the step";
  EXPECT_FALSE(constant());
  EXPECT_EQ(acceleration(), Vec3(Vec3::Zero()));
  EXPECT_FALSE(ends_with(-1.5 * 1 / length)) << "once a step";
}

}  // namespace
}  // namespace talus
