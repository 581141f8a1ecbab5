#include "base/line_attitude.hpp"

#include <gtest/gtest.h>

namespace talus {
namespace {

TEST(LineAttitude, TrendRunsClockwiseFromNorthAndPlungeIsPositiveDownwards) {
  EXPECT_NEAR(attitude_of(Vec3(0, 2, 0)).trend, 0, 1e-12);
  EXPECT_NEAR(attitude_of(Vec3(3, 0, 0)).trend, 90, 1e-12);
  EXPECT_NEAR(attitude_of(Vec3(0, -1, 0)).trend, 180, 1e-12);
  EXPECT_NEAR(attitude_of(Vec3(-1, 1, 0)).trend, 315, 1e-12);
  EXPECT_NEAR(attitude_of(Vec3(1, 0, -1)).plunge, 45, 1e-12);
  EXPECT_NEAR(attitude_of(Vec3(1, 0, 1)).plunge, -45, 1e-12);
}

TEST(LineAttitude, AVerticalLineHasNoTrend) {
  EXPECT_EQ(attitude_of(Vec3(0, 0, -5)).trend, 0);
  EXPECT_NEAR(attitude_of(Vec3(0, 0, -5)).plunge, 90, 1e-12);
}

}  // namespace
}  // namespace talus
