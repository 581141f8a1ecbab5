#include "orientation/kinematics.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace talus {
namespace {

PlaneFindings alone(const PlaneAttitude& plane, const KinematicSetting& setting) {
  return kinematic_check(std::vector{plane}, setting).planes.front();
}

IntersectionFindings between(const PlaneAttitude& a, const PlaneAttitude& b, const KinematicSetting& setting) {
  return kinematic_check(std::vector{a, b}, setting).intersections.at(0);
}

// Wyllie & Mah (2004), section 6.2: ψf > ψp > φ, and the strikes parallel within ±20°.
TEST(PlanarSliding, IsPossibleBetweenFrictionAngleAndFaceDip) {
  const KinematicSetting setting{{70, 150}, 30, 20};
  EXPECT_TRUE(alone({50, 150}, setting).planar);
  EXPECT_TRUE(alone({31, 150}, setting).planar);
  EXPECT_FALSE(alone({29, 150}, setting).planar);
  EXPECT_TRUE(alone({69, 150}, setting).planar);
  EXPECT_FALSE(alone({71, 150}, setting).planar);
}

TEST(PlanarSliding, HasLimitsAtTheSides) {
  const KinematicSetting setting{{70, 350}, 30, 20};
  EXPECT_TRUE(alone({50, 9}, setting).planar);
  EXPECT_FALSE(alone({50, 11}, setting).planar);
  EXPECT_TRUE(alone({50, 11}, setting).planar_unlimited);
  EXPECT_FALSE(alone({50, 170}, setting).planar_unlimited);
}

TEST(PlanarSliding, DaylightsUpToTheFacesApparentDip) {
  // 40° off the face's direction a face of 60° has an apparent dip of atan(tan 60° cos 40°) = 53.0°.
  const KinematicSetting setting{{60, 100}, 20, 20};
  EXPECT_TRUE(alone({52.9, 140}, setting).planar_unlimited);
  EXPECT_FALSE(alone({53.1, 140}, setting).planar_unlimited);
}

TEST(PlanarSliding, InAVerticalFaceIsPossibleForAllSteepPlanesOfItsHalf) {
  const KinematicSetting setting{{90, 100}, 30, 90};
  EXPECT_TRUE(alone({89, 189}, setting).planar_unlimited);
  EXPECT_FALSE(alone({89, 191}, setting).planar_unlimited);
}

// Hoek & Bray (1981), comprehensive wedge example: planes 45/105 and 70/235, face 65/185; the line of intersection
// plunges 31.20° towards 157.73°.
TEST(WedgeSliding, HasTheLineOfHoekAndBraysExample) {
  const IntersectionFindings found = between({45, 105}, {70, 235}, {{65, 185}, 30, 20});
  EXPECT_NEAR(found.line.plunge, 31.20, 0.005);
  EXPECT_NEAR(found.line.trend, 157.73, 0.005);
  EXPECT_TRUE(found.wedge);
  EXPECT_FALSE(found.on_one_plane);
  EXPECT_FALSE(between({45, 105}, {70, 235}, {{65, 185}, 31.3, 20}).wedge);
}

// The wedge 40°/130°, 60°/220° of Wyllie & Mah: its planes are perpendicular in strike, its line plunges 37.058°.
TEST(WedgeSliding, DependsOnThePlungeOfTheLine) {
  const IntersectionFindings found = between({40, 130}, {60, 220}, {{70, 160}, 37, 20});
  EXPECT_NEAR(found.line.plunge, 37.058, 0.0005);
  EXPECT_TRUE(found.wedge);
  EXPECT_FALSE(between({40, 130}, {60, 220}, {{70, 160}, 37.1, 20}).wedge);
  EXPECT_FALSE(between({40, 130}, {60, 220}, {{30, 160}, 20, 20}).wedge);  // does not daylight
}

// Goodman & Shi (1985): it slides on plane 1 alone when its steepest descent leads away from plane 2, d₁·n₂ > 0.
TEST(WedgeSliding, IsOnOnePlaneWhoseDescentLeadsAwayFromTheOther) {
  // d₁·n₂ = cos 50° sin 70° cos 50° − sin 50° cos 70° = +0.126 for 50/180 and 70/130, and −0.243 for 50/180 and 80/80.
  const KinematicSetting setting{{75, 190}, 30, 20};
  EXPECT_TRUE(between({50, 180}, {70, 130}, setting).wedge);
  EXPECT_TRUE(between({50, 180}, {70, 130}, setting).on_one_plane);
  EXPECT_TRUE(between({50, 180}, {80, 80}, setting).wedge);
  EXPECT_FALSE(between({50, 180}, {80, 80}, setting).on_one_plane);
}

TEST(WedgeSliding, OnOnePlaneIsPossibleThoughTheLineIsFlat) {
  // Seen from 50/180 the line runs near the strike of 85/150, about atan(tan 50° cos 60°) = 31° steep.
  const KinematicSetting setting{{75, 200}, 45, 20};
  const IntersectionFindings found = between({50, 180}, {85, 150}, setting);
  ASSERT_LT(found.line.plunge, 45);
  EXPECT_FALSE(found.wedge);
  EXPECT_TRUE(found.wedge_flat);
  EXPECT_FALSE(between({50, 180}, {85, 150}, {{75, 200}, 51, 20}).wedge_flat);
}

// Goodman (1980): layers slip when (90° − dip) + φ ≤ face dip. Wyllie & Mah (2004), section 9.3: the same condition.
TEST(FlexuralToppling, IsPossibleForLayersSteeperThanTheSlipLimit) {
  const KinematicSetting setting{{65, 100}, 30, 20};  // 90 − 65 + 30 = 55
  EXPECT_TRUE(alone({56, 280}, setting).flexural);
  EXPECT_FALSE(alone({54, 280}, setting).flexural);
  EXPECT_TRUE(alone({80, 261}, setting).flexural);
  EXPECT_FALSE(alone({80, 259}, setting).flexural);
  EXPECT_FALSE(alone({80, 100}, setting).flexural);
}

TEST(FlexuralToppling, IsImpossibleInAFaceFlatterThanFriction) {
  EXPECT_FALSE(alone({90, 280}, {{29, 100}, 30, 20}).flexural);
  EXPECT_TRUE(alone({89.5, 280}, {{31, 100}, 30, 20}).flexural);
}

// Hudson & Harrison (1997), figure 18.6: intersections that plunge into the slope between 90° − face dip and 90°, base
// planes that dip out of it up to the face's dip.
TEST(DirectToppling, NeedsSteepLinesIntoTheSlope) {
  const KinematicSetting setting{{70, 90}, 35, 20};
  // Two planes that dip 60° to 230° and 310° meet in a line towards 270°: tan(plunge) = tan 60° · cos 40°, 53.0°.
  const IntersectionFindings found = between({60, 230}, {60, 310}, setting);
  EXPECT_NEAR(found.line.trend, 270, 1e-9);
  EXPECT_NEAR(found.line.plunge, 53.0, 0.05);
  EXPECT_TRUE(found.direct);
  EXPECT_FALSE(between({60, 230}, {60, 310}, {{36, 90}, 35, 20}).direct);  // 90 − 36 = 54
  EXPECT_FALSE(between({60, 50}, {60, 130}, setting).direct);              // out of the slope
}

TEST(DirectToppling, IsObliqueOutsideTheLimitsWithinFrictionOfTheVertical) {
  const KinematicSetting setting{{70, 90}, 35, 20};
  // The same wedge turned by 45°: towards 315°, still 53.0°, less than 90 − 35 = 55.
  EXPECT_FALSE(between({60, 275}, {60, 355}, setting).direct);
  EXPECT_FALSE(between({60, 275}, {60, 355}, setting).direct_oblique);
  EXPECT_TRUE(between({60, 275}, {60, 355}, {{70, 90}, 38, 20}).direct_oblique);
}

TEST(DirectToppling, NeedsBasePlanesThatDipOutNoSteeperThanTheFace) {
  const KinematicSetting setting{{70, 90}, 35, 20};
  EXPECT_TRUE(alone({10, 95}, setting).base);
  EXPECT_TRUE(alone({69, 90}, setting).base);
  EXPECT_FALSE(alone({71, 90}, setting).base);
  EXPECT_FALSE(alone({10, 270}, setting).base);
  EXPECT_TRUE(alone({10, 150}, setting).base_oblique);
  EXPECT_FALSE(alone({40, 150}, setting).base_oblique);
}

TEST(KinematicCheck, CountsPlanesAndPairs) {
  const std::vector<PlaneAttitude> planes{{45, 105}, {70, 235}, {45, 105}, {85, 5}};
  const KinematicResult result = kinematic_check(planes, {{65, 185}, 30, 20});
  EXPECT_EQ(result.intersections.size(), 5u);  // of six pairs one is parallel
  EXPECT_EQ(result.counts.wedge, (KinematicCount{2, 5}));
  EXPECT_EQ(result.counts.flexural, (KinematicCount{1, 4}));
  EXPECT_DOUBLE_EQ(result.counts.flexural.percent(), 25);
  EXPECT_EQ(kinematic_check({}, {}).counts.wedge.percent(), 0);
  EXPECT_EQ(kinematic_counts(planes, {{65, 185}, 30, 20}), result.counts);
  EXPECT_EQ(kinematic_counts(planes, {{65, 185}, 30, 20}, false).wedge, KinematicCount{});
  EXPECT_EQ(kinematic_counts(planes, {{65, 185}, 30, 20}, false).flexural, result.counts.flexural);
}

TEST(KinematicCheck, RefusesAnglesOutOfRange) {
  EXPECT_THROW(kinematic_check({}, {{91, 0}, 30, 20}), std::invalid_argument);
  EXPECT_THROW(kinematic_check({}, {{60, 0}, -1, 20}), std::invalid_argument);
  EXPECT_THROW(kinematic_check({}, {{60, 0}, 30, 91}), std::invalid_argument);
}

}  // namespace
}  // namespace talus
