#include "solve/dynamics/step_control.hpp"

#include <gmock/gmock.h>

namespace talus {
namespace {

StepControl control() {
  StepControl control({0.01, 1e-3, 8, 1e-2}, 10,
                      2);  // limits: 0.1 m, 2e-3 m, 8 iterations; shortest 0.01 of the longest
  control.begin_stage(1.0);
  return control;
}

TEST(StepControl, StepFarWithinItsLimitsGrowsByHalfUpToTheLongest) {
  StepControl c = control();
  c.accept({1e-3, 1e-6, 2}, 0.1);
  EXPECT_DOUBLE_EQ(c.length(), 0.15);
  c.accept({1e-3, 1e-6, 2}, 0.9);
  EXPECT_DOUBLE_EQ(c.length(), 1.0);
}

TEST(StepControl, DisplacementTimeErrorAndIterationsEachShortenTheStep) {
  StepControl c = control();
  c.accept({0.16, 0, 2}, 0.5);
  EXPECT_NEAR(c.length(), 0.5 * 0.8 * 0.1 / 0.16, 1e-12);
  c.accept({0, 8e-3, 2}, 0.5);
  EXPECT_NEAR(c.length(), 0.5 * 0.8 * 0.5, 1e-12);
  c.accept({0, 0, 9}, 0.5);
  EXPECT_NEAR(c.length(), 0.35, 1e-12);
}

TEST(StepControl, StepThatBreaksALimitIsRefusedUnlessItIsTheShortest) {
  StepControl c = control();
  EXPECT_TRUE(c.acceptable({0.14, 2.5e-3, 30}, 1.0));
  EXPECT_FALSE(c.acceptable({0.16, 0, 2}, 1.0));
  EXPECT_FALSE(c.acceptable({0, 4e-3, 2}, 1.0));
  EXPECT_TRUE(c.acceptable({5, 5, 50}, 0.01));
  c.refuse({5, 0, 2}, 1.0);
  EXPECT_DOUBLE_EQ(c.length(), 0.2);
  c.refuse({0, 0, 0}, 0.015);  // did not converge
  EXPECT_DOUBLE_EQ(c.length(), 0.01);
}

}  // namespace
}  // namespace talus
