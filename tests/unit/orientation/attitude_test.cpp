#include "orientation/attitude.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"

namespace talus {
namespace {

constexpr double rounding = 1e-12;

TEST(Attitude, ThePoleOfAPlaneThatDipsEastPointsDownToTheWest) {
  const Vec3 pole = pole_of({30, 90});
  EXPECT_NEAR(pole.x(), -0.5, rounding);
  EXPECT_NEAR(pole.y(), 0, rounding);
  EXPECT_NEAR(pole.z(), -std::sqrt(3) / 2, rounding);
  const Vec3 descent = dip_vector_of({30, 90});
  EXPECT_NEAR(descent.x(), std::sqrt(3) / 2, rounding);
  EXPECT_NEAR(descent.z(), -0.5, rounding);
}

TEST(Attitude, ComesBackFromANormalOfEitherSense) {
  for (const double dip : {1.0, 37.5, 89.0})
    for (const double direction : {0.0, 12.0, 135.0, 270.0, 359.0})
      for (const double sense : {1.0, -2.5}) {
        const PlaneAttitude plane = attitude_of_normal(sense * pole_of({dip, direction}));
        EXPECT_NEAR(plane.dip, dip, 1e-9);
        EXPECT_NEAR(plane.dip_direction, direction, 1e-9);
      }
}

TEST(Attitude, OfALevelPlaneHasDirectionZero) { EXPECT_EQ(attitude_of_normal(Vec3(0, 0, 3)), (PlaneAttitude{0, 0})); }

TEST(Attitude, OverturnedPlanesDipTheOtherWay) {
  EXPECT_EQ(upright({100, 30}), (PlaneAttitude{80, 210}));
  EXPECT_EQ(upright({60, -90}), (PlaneAttitude{60, 270}));
  EXPECT_NEAR(std::abs(pole_of({100, 30}).dot(pole_of({80, 210}))), 1, rounding);
}

TEST(Attitude, OfAStrikeByTheRightHandRuleDipsToItsRight) {
  EXPECT_EQ(dip_direction_of_strike(0), 90);
  EXPECT_EQ(dip_direction_of_strike(300), 30);
}

TEST(Attitude, AzimuthsDifferByAtMostHalfACircle) {
  EXPECT_EQ(azimuth_difference(350, 10), 20);
  EXPECT_EQ(azimuth_difference(90, 270), 180);
  EXPECT_EQ(azimuth_within_circle(-1e-20), 0);
}

TEST(Attitude, IsWrittenAndReadAsText) {
  EXPECT_EQ(plane_text({45, 120.5}), "45/120.5");
  EXPECT_EQ(plane_text({7.25, 0}), "7.25/0");
  EXPECT_EQ(plane_from_text(" 45 / 120.5", "--face"), (PlaneAttitude{45, 120.5}));
  EXPECT_EQ(plane_from_text("90/360", "--face"), (PlaneAttitude{90, 0}));
}

TEST(Attitude, TextThatIsNoneIsRefusedWithItsPlace) {
  for (const char* text : {"", "45", "45/", "45-120", "91/10", "45/361", "-5/10"}) {
    try {
      plane_from_text(text, "--face");
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      EXPECT_EQ(error.place(), "--face");
    }
  }
}

}  // namespace
}  // namespace talus
