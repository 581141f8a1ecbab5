#include "orientation/projection.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "orientation/net_curves.hpp"

namespace talus {
namespace {

constexpr double net_rounding = 1e-12;

TEST(Projection, PutsALineOfFortyFiveDegreesWhereTheTextbooksDo) {
  // From the middle: Wulff tan(45°/2), Schmidt √2 sin(45°/2); a line that trends east lies to the right.
  const Vec3 line = direction_of({90, 45});
  EXPECT_NEAR(projected(line, Projection::equal_angle).x(), std::tan(radians(22.5)), net_rounding);
  EXPECT_NEAR(projected(line, Projection::equal_area).x(), std::sqrt(2) * std::sin(radians(22.5)), net_rounding);
  EXPECT_NEAR(projected(line, Projection::equal_area).y(), 0, net_rounding);
}

TEST(Projection, HasNorthAtTheTopAndLevelLinesOnTheRim) {
  for (const Projection projection : {Projection::equal_area, Projection::equal_angle}) {
    EXPECT_NEAR((projected(direction_of({0, 0}), projection) - Vec2(0, 1)).norm(), 0, net_rounding);
    EXPECT_NEAR(projected(direction_of({217, 0}), projection).norm(), 1, net_rounding);
    EXPECT_EQ(projected(Vec3(0, 0, -1), projection), Vec2(0, 0));
  }
}

TEST(Projection, IsUndoneByItsInverseInsideAndOutsideTheRim) {
  for (const Projection projection : {Projection::equal_area, Projection::equal_angle})
    for (const double plunge : {-30.0, 0.0, 12.0, 60.0, 89.9})
      for (const double trend : {0.0, 77.0, 180.0, 311.0}) {
        const Vec3 line = direction_of({trend, plunge});
        EXPECT_NEAR((unprojected(projected(line, projection), projection) - line).norm(), 0, 1e-9);
      }
}

TEST(Projection, BySchmidtKeepsAreas) {
  // A band of the hemisphere between two plunges has the area 2π(sin − sin); on the net of area π it is half of that.
  const double inner = projected(direction_of({0, 70}), Projection::equal_area).norm();
  const double outer = projected(direction_of({0, 20}), Projection::equal_area).norm();
  EXPECT_NEAR(outer * outer - inner * inner, std::sin(radians(70)) - std::sin(radians(20)), net_rounding);
}

TEST(GreatCircle, IsACircleOnWulffsNet) {
  // Centre tan(dip) behind the net's middle, radius 1/cos(dip).
  for (const Vec3& line : great_circle({50, 90})) {
    const Vec2 place = projected(line, Projection::equal_angle);
    EXPECT_NEAR((place - Vec2(-std::tan(radians(50)), 0)).norm(), 1 / std::cos(radians(50)), 1e-9);
  }
}

TEST(GreatCircle, LiesInItsPlaneAndBelowTheHorizon) {
  for (const Vec3& line : great_circle({63, 212})) {
    EXPECT_NEAR(line.dot(pole_of({63, 212})), 0, net_rounding);
    EXPECT_LE(line.z(), net_rounding);
  }
}

TEST(SmallCircle, KeepsItsAngleAndComesBackOnTheOtherSide) {
  const Vec3 axis = direction_of({90, 10});
  const std::vector<NetCurve> curves = small_circle(axis, 25);
  ASSERT_EQ(curves.size(), 3u);  // down, above the horizon, down again
  for (const NetCurve& curve : curves)
    for (const Vec3& line : curve) {
      EXPECT_LE(line.z(), net_rounding);
      EXPECT_NEAR(std::abs(line.dot(axis)), std::cos(radians(25)), 1e-3);
    }
  EXPECT_LT(curves[1].front().x() * curves[0].back().x(), 0);  // it enters opposite to where it left
}

TEST(SmallCircle, BelowTheHorizonIsOnePiece) { EXPECT_EQ(small_circle(Vec3(0, 0, -1), 30).size(), 1u); }

TEST(WindowOutline, OfRangesAcrossTheRimComesBackOnTheOtherSide) {
  EXPECT_EQ(window_outline(RangeWindow{30, 60, 100, 140}).size(), 1u);
  const std::vector<NetCurve> curves = window_outline(RangeWindow{70, 110, 350, 20});
  EXPECT_EQ(curves.size(), 3u);
  for (const NetCurve& curve : curves)
    for (const Vec3& pole : curve) {
      EXPECT_LE(pole.z(), net_rounding);
      EXPECT_TRUE(contains(RangeWindow{69, 111, 349, 21}, pole));
    }
}

TEST(DaylightEnvelope, HoldsPolesOfPlanesOfTheFacesApparentDip) {
  // tan δ = tan 65° · cos Δ: 30° off the face's direction it is 61.7°.
  EXPECT_NEAR(degrees(std::atan(std::tan(radians(65)) * std::cos(radians(30)))), 61.7, 0.05);
  for (const Vec3& pole : daylight_envelope({65, 140})) {
    const PlaneAttitude plane = attitude_of_normal(pole);
    if (plane.dip < 1e-6) continue;
    EXPECT_NEAR(std::tan(radians(plane.dip)),
                std::tan(radians(65)) * std::cos(radians(azimuth_difference(plane.dip_direction, 140))), 1e-9);
  }
}

}  // namespace
}  // namespace talus
