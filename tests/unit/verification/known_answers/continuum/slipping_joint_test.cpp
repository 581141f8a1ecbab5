#include "verification/known_answers/continuum/slipping_joint.hpp"

#include <gtest/gtest.h>

using namespace talus;

namespace {

const SlippingJoint plate{
    .height = 2, .width = 1, .young = 88.9e9, .stiffness = 220e9, .friction_angle = 16, .slipping_length = 0.54};

}  // namespace

TEST(SlippingJoint, HasThePublishedStiffnesses) {
  EXPECT_NEAR(plate.loading(), 36.28e9, 0.005e9);
  EXPECT_NEAR(plate.first_unloading(), 38.89e9, 0.005e9);
  EXPECT_NEAR(plate.last_unloading(), 34.42e9, 0.005e9);
}

TEST(SlippingJoint, DoesNotSlipForwardAtAFrictionAngleOfItsOwnInclination) {
  SlippingJoint rough = plate;
  rough.friction_angle = 45;
  EXPECT_DOUBLE_EQ(rough.loading(), rough.first_unloading());
  EXPECT_LT(rough.last_unloading(), rough.loading());
}

TEST(SlippingJoint, LoadsAndUnloadsAlikeWithoutFriction) {
  SlippingJoint smooth = plate;
  smooth.friction_angle = 0;
  EXPECT_DOUBLE_EQ(smooth.loading(), smooth.last_unloading());
  EXPECT_LT(smooth.loading(), smooth.first_unloading());
}
