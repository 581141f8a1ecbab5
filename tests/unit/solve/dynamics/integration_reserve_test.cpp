#include "solve/dynamics/integration_reserve.hpp"

#include <gtest/gtest.h>

#include <array>

#include "support/solver_scenes.hpp"

namespace talus {
namespace {

/// A rigid cube whose acceleration along x changes from step to step of Newmark's method.
class IntegrationReserveTest : public testing::Test {
 protected:
  IntegrationReserveTest() : system_(test::cube_on_slab()), set_(test::rock_project(30, {}), rigid(system_)) {
    step_.length = length;
    reserve_.give(step_, length);
  }
  static BlockSystem& rigid(BlockSystem& system) {
    system.blocks[1].body = BodyKind::rigid;
    return system;
  }
  double& acceleration() { return set_.nodes.acceleration[set_.rigid[set_.bodies[1].rigid].centre].x(); }
  void go_to(double after) {
    reserve_.note_start(step_);
    acceleration() = after;
    reserve_.hold(step_, length);
  }
  /// mΔ²a²/32, Krenk's for β = 9/16 and γ = 1.
  double held_for(double a) const { return set_.bodies[1].mass() * length * length * a * a / 32; }

  static constexpr double length = 0.01;  // s

  BlockSystem system_;
  BodySet set_;
  StepContext step_;
  IntegrationReserve reserve_{set_};
};

TEST_F(IntegrationReserveTest, HoldsWhatAnAccelerationPaysAsItGrowsAndGivesItBack) {
  for (const double a : {2.0, 5.0, 3.0, 0.0}) {
    go_to(a);
    EXPECT_NEAR(reserve_.total(), held_for(a), 1e-12 * held_for(5)) << a;
  }
}

TEST_F(IntegrationReserveTest, HoldsNothingOfStepsThatGoOnWithTheirEnd) {
  set_.bodies[1].constant_acceleration = true;
  go_to(5);
  EXPECT_EQ(reserve_.total(), 0);
  set_.bodies[1].constant_acceleration = false;
  go_to(3);
  EXPECT_EQ(reserve_.total(), 0) << "nobody has paid for it";
}

TEST_F(IntegrationReserveTest, LosesWithAnAccelerationThatIsTakenAway) {
  go_to(5);
  acceleration() = 0;
  go_to(0);
  EXPECT_EQ(reserve_.total(), 0);
}

TEST_F(IntegrationReserveTest, LongerStepsHoldNoMoreThanWasPaid) {
  go_to(5);
  step_.length = 3 * length;
  go_to(5);
  EXPECT_NEAR(reserve_.total(), held_for(5), 1e-12 * held_for(5));
}

TEST_F(IntegrationReserveTest, AfterAShorterStepALongOneFindsWhatWasPaid) {
  go_to(5);
  step_.length = length / 2;
  reserve_.begin_step(step_);
  go_to(5);
  EXPECT_NEAR(reserve_.total(), held_for(5), 1e-12 * held_for(5));
  step_.length = length;
  reserve_.begin_step(step_);
  EXPECT_NEAR(acceleration(), 5, 1e-12);
}

TEST_F(IntegrationReserveTest, ALongerStepBeginsWithAsMuchAccelerationAsIsPaidFor) {
  step_.length = length / 2;
  reserve_.give(step_, length);
  go_to(5);
  step_.length = length;
  reserve_.begin_step(step_);
  EXPECT_NEAR(acceleration(), 2.5, 1e-12);
  step_.length = 0.8 * length;
  reserve_.begin_step(step_);
  EXPECT_NEAR(acceleration(), 2.5 / 0.8, 1e-12) << "tried again, shorter";
  step_.length = length;
  reserve_.begin_step(step_);
  go_to(0);
  EXPECT_NEAR(reserve_.total(), 0, 1e-12 * held_for(5));
}

TEST_F(IntegrationReserveTest, WhatImpactsGiveComesOutOfIt) {
  go_to(5);
  reserve_.release(std::array{0, 1}, -1);
  EXPECT_EQ(acceleration(), 5) << "they took";
  reserve_.release(std::array{0, 1}, 0.75 * held_for(5));
  EXPECT_NEAR(reserve_.total(), 0.25 * held_for(5), 1e-12 * held_for(5));
  EXPECT_NEAR(acceleration(), 2.5, 1e-12) << "as much as is paid for";
  reserve_.release(std::array{0, 1}, held_for(5));
  EXPECT_EQ(reserve_.total(), 0);
  EXPECT_EQ(acceleration(), 0);
}

TEST_F(IntegrationReserveTest, OtherIntegratorsHoldNothing) {
  step_.integration = TimeIntegration::constant_acceleration();
  go_to(5);
  EXPECT_EQ(reserve_.total(), 0);
}

}  // namespace
}  // namespace talus
