#include "solve/dynamics/acceleration_reset.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/solver_scenes.hpp"

namespace talus {
namespace {

constexpr double length = 0.01;  // s

/// A rigid cube that moves along x with an acceleration, and comes to another in a step of Newmark's method.
class AccelerationResetTest : public testing::Test {
 protected:
  AccelerationResetTest() : system_(test::cube_on_slab()), set_(project(), rigid(system_)), reset_(set_, tolerances_) {
    step_.length = length;
    step_.mesh_size = 1;
    increment_ = Increment::Zero(set_.unknowns());
  }
  static Project project() { return test::rock_project(30, {}); }
  static BlockSystem& rigid(BlockSystem& system) {
    system.blocks[1].body = BodyKind::rigid;
    return system;
  }
  int centre() const { return set_.rigid[set_.bodies[1].rigid].centre; }
  Vec3& acceleration() { return set_.nodes.acceleration[centre()]; }

  /// Another step, with this velocity and acceleration at its start.
  void begin(double speed, double before) {
    reset_.note_contact_forces(set_, {}, {});
    set_.nodes.velocity[centre()] = {speed, 0, 0};
    acceleration() = {before, 0, 0};
  }
  /// The step converges to this acceleration at its end; whether it is reset.
  bool ends_with(double after) {
    const double beta = step_.integration.beta;
    const Vec3 displacement = length * set_.nodes.velocity[centre()] +
                              length * length * ((0.5 - beta) * acceleration() + beta * Vec3(after, 0, 0));
    increment_.segment<3>(3 * set_.nodes.dof_block[centre()]) = displacement;
    return reset_.reset_to_end(set_, step_, increment_);
  }
  /// Energy that such a step returns to the cube, of its kinetic energy.
  double returned_energy(double after) {
    const double before = acceleration().x(), speed = set_.nodes.velocity[centre()].x();
    return (step_.integration.beta - 0.5) * length * length * after * (before - after) / (0.5 * speed * speed);
  }
  /// The acceleration near the one before that returns this much.
  double after_that_returns(double energy) {
    const double before = acceleration().x(), speed = set_.nodes.velocity[centre()].x();
    const double product = energy * 0.5 * speed * speed / ((step_.integration.beta - 0.5) * length * length);
    return 0.5 * (before + std::sqrt(before * before - 4 * product));
  }
  /// The ground pushes the cube as it never did before: it has taken a blow.
  void strike() {
    ContactSet contacts;
    ContactPoint point{};
    point.bodies[1] = 1;
    point.normal = -Vec3::UnitZ();
    contacts.points = {point};
    reset_.note_contact_forces(set_, contacts, {{.normal_force = 1e6}});
    reset_.drop_after_blows(set_);
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
  EXPECT_EQ(acceleration().x(), 10);
}

TEST_F(AccelerationResetTest, ResetsAnAccelerationThatHasEnded) {
  for (const double left : {0.9 * tolerances_.acceleration_left, 0.0, -0.1}) {
    begin(1, 10);
    EXPECT_TRUE(ends_with(10 * left)) << left;
    EXPECT_NEAR(acceleration().x(), 10 * left, 1e-9);
    EXPECT_FALSE(ends_with(10 * left)) << "it ends as it begins";
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
      EXPECT_NEAR(acceleration().x(), too_much ? 300 * left : 300, 1e-9);
    }
  EXPECT_GT(resets, 0);
  EXPECT_GT(kept, 0);
}

TEST_F(AccelerationResetTest, ReturnsLessEnergyStillOnceReset) {
  const double between = std::sqrt(tolerances_.returned_energy * tolerances_.returned_energy_after_reset);
  begin(1, 50);
  EXPECT_FALSE(ends_with(after_that_returns(between)));
  begin(1, 300);
  ASSERT_TRUE(ends_with(50));
  EXPECT_TRUE(ends_with(after_that_returns(between)));
  EXPECT_FALSE(ends_with(after_that_returns(0.5 * tolerances_.returned_energy_after_reset)));
}

TEST_F(AccelerationResetTest, GivesABodyAfterABlowTheAccelerationItEndsWith) {
  begin(1, 300);
  strike();
  EXPECT_EQ(acceleration(), Vec3(Vec3::Zero()));
  EXPECT_TRUE(ends_with(5));
  EXPECT_NEAR(acceleration().x(), 5, 1e-12);
  EXPECT_FALSE(ends_with(5)) << "once";
}

TEST_F(AccelerationResetTest, DoesNotLetTheRestOfABlowThrowABodyBack) {
  begin(1, 300);
  strike();
  EXPECT_FALSE(ends_with(-1.5 * 1 / length)) << "more than stops it in the step";
  EXPECT_EQ(acceleration(), Vec3(Vec3::Zero()));
}

}  // namespace
}  // namespace talus
