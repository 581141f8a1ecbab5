#include "solve/fading_inertia.hpp"

#include <gmock/gmock.h>

namespace talus {
namespace {

TEST(FadingInertia, fades_with_what_is_out_of_balance_by_its_power_of_three_halves) {
  FadingInertia fading;
  fading.taken(1e-3, 1e-2);
  EXPECT_DOUBLE_EQ(fading.share(), 1);
  fading.taken(1e-6, 1e-2 / 16);
  EXPECT_DOUBLE_EQ(fading.share(), 1.0 / 64);
  fading.taken(1e-6, 1e-2 / 17);  // the power of two that is not less
  EXPECT_DOUBLE_EQ(fading.share(), 1.0 / 64);
  fading.taken(1e-9, 1e-9);
  EXPECT_DOUBLE_EQ(fading.share(), 0x1p-20);
}

TEST(FadingInertia, what_stays_out_of_balance_keeps_its_inertia_or_gets_it_back) {
  FadingInertia fading;
  for (const double imbalance : {1e-2, 1e-2, 3e-2, 3e-2}) fading.taken(1e-3, imbalance);
  EXPECT_DOUBLE_EQ(fading.share(), 1);
  fading.taken(1e-6, 3e-2 / 16);
  EXPECT_DOUBLE_EQ(fading.share(), 0x1p-6);
  fading.taken(1e-6, 0.9999 * 3e-2 / 16);
  EXPECT_DOUBLE_EQ(fading.share(), 0x1p-4);
  for (int k = 0; k < 2; ++k) fading.taken(1e-6, 3e-2 / 16);
  EXPECT_DOUBLE_EQ(fading.share(), 1);
}

TEST(FadingInertia, rounding_changes_nothing) {
  FadingInertia fading;
  fading.taken(1e-3, 1e-2);
  fading.taken(1e-6, 1e-2 / 16);
  fading.taken(1e-16, 1e-12);
  EXPECT_DOUBLE_EQ(fading.share(), 1.0 / 64);
}

TEST(FadingInertia, steps_lead_no_farther_than_twice_as_far_as_those_with_all_of_it) {
  FadingInertia fading;
  fading.taken(1e-3, 1e-2);
  fading.taken(0.9e-3, 1e-2 / 0x1p8);
  EXPECT_DOUBLE_EQ(fading.share(), 0.5) << "0.9e-3 m, twice";
  EXPECT_FALSE(fading.led_astray(true, 1.9e-3));
  EXPECT_TRUE(fading.led_astray(true, 2.1e-3));
  fading.restore(true, 2.1e-3);
  EXPECT_DOUBLE_EQ(fading.share(), 1);
  EXPECT_FALSE(fading.led_astray(true, 1)) << "it had all of it";
}

TEST(FadingInertia, a_step_that_led_too_far_is_taken_anew_with_as_much_more) {
  FadingInertia fading;
  fading.taken(1e-3, 1e-2);
  fading.taken(1e-6, 1e-2 / 0x1p6);
  EXPECT_DOUBLE_EQ(fading.share(), 0x1p-9);
  fading.restore(true, 0.02);
  EXPECT_DOUBLE_EQ(fading.share(), 0x1p-5) << "ten times too far: the next power of two";
  EXPECT_TRUE(fading.led_astray(false, 0)) << "did not settle";
  fading.restore(false, 0);
  EXPECT_DOUBLE_EQ(fading.share(), 1);
}

}  // namespace
}  // namespace talus
