#include "solve/step_control.hpp"

#include <gmock/gmock.h>

namespace talus {
namespace {

StepControl control() {
  StepControl control({0.01, 1e-3, 8, 1e-2}, 10,
                      2);  // limits: 0.1 m, 2e-3 m, 8 iterations; shortest 0.01 of the longest
  control.begin_stage(1.0);
  return control;
}

TEST(StepControl, a_step_far_within_its_limits_grows_by_half_up_to_the_longest) {
  StepControl c = control();
  c.taken({1e-3, 1e-6, 2}, 0.1);
  EXPECT_DOUBLE_EQ(c.length(), 0.15);
  c.taken({1e-3, 1e-6, 2}, 0.9);
  EXPECT_DOUBLE_EQ(c.length(), 1.0);
}

TEST(StepControl, displacement_time_error_and_iterations_each_shorten_the_step) {
  StepControl c = control();
  c.taken({0.16, 0, 2}, 0.5);
  EXPECT_NEAR(c.length(), 0.5 * 0.8 * 0.1 / 0.16, 1e-12);
  c.taken({0, 8e-3, 2}, 0.5);
  EXPECT_NEAR(c.length(), 0.5 * 0.8 * 0.5, 1e-12);
  c.taken({0, 0, 9}, 0.5);
  EXPECT_NEAR(c.length(), 0.35, 1e-12);
}

TEST(StepControl, a_step_that_breaks_a_limit_is_refused_unless_it_is_the_shortest) {
  StepControl c = control();
  EXPECT_TRUE(c.acceptable({0.14, 2.5e-3, 30}, 1.0));
  EXPECT_FALSE(c.acceptable({0.16, 0, 2}, 1.0));
  EXPECT_FALSE(c.acceptable({0, 4e-3, 2}, 1.0));
  EXPECT_TRUE(c.acceptable({5, 5, 50}, 0.01));
  c.refused({5, 0, 2}, 1.0);
  EXPECT_DOUBLE_EQ(c.length(), 0.2);
  c.refused({0, 0, 0}, 0.015);  // did not settle
  EXPECT_DOUBLE_EQ(c.length(), 0.01);
}

}  // namespace
}  // namespace talus
