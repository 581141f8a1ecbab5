#include "removability/removability.hpp"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <cmath>

#include "base/units.hpp"

namespace talus {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const Vec3 weight(0, 0, -1e6);

/// A plane that dips by so much, below the block.
HoldingPlane below(double dip, double dip_direction, double friction_angle, double cohesion = 0) {
  const double d = radians(dip), a = radians(dip_direction);
  return {-Vec3(std::sin(d) * std::sin(a), std::sin(d) * std::cos(a), std::cos(d)), std::tan(radians(friction_angle)),
          cohesion};
}

/// Hoek and Bray, Rock Slope Engineering (1981), chapter 7: F = (c A + W cos ψ tan φ) / (W sin ψ).
TEST(Removability, OfABlockOnOneJointIsThatOfPlaneFailure) {
  const std::vector<HoldingPlane> planes{below(35, 90, 30, 2e5)};
  const Removability found = removability(planes, true, weight);
  EXPECT_EQ(found.leaving, Leaving::slides_on_one);
  EXPECT_THAT(found.on, ElementsAre(0));
  const double dip = radians(35);
  ASSERT_TRUE(found.factor);
  EXPECT_NEAR(*found.factor, (2e5 + 1e6 * std::cos(dip) * std::tan(radians(30))) / (1e6 * std::sin(dip)), 1e-12);
  EXPECT_LT((found.direction - Vec3(std::cos(dip), 0, -std::sin(dip))).norm(), 1e-12);
}

/// Hoek and Bray, chapter 8: F = sin β / sin(ξ/2) · tan φ / tan ψ_i of a wedge whose planes lie alike on both sides.
TEST(Removability, OfASymmetricWedgeIsThatOfHoekAndBray) {
  const double plunge = radians(30), half = radians(40);  // ξ/2
  // Planes through the line of intersection, turned by ±ξ/2 from the upright plane through it.
  const Vec3 line(0, std::cos(plunge), -std::sin(plunge)), across(1, 0, 0), up = across.cross(line);
  std::vector<HoldingPlane> planes;
  for (const double side : {1.0, -1.0}) {
    const Vec3 in_plane = std::cos(half) * up + side * std::sin(half) * across;
    Vec3 normal = in_plane.cross(line).normalized();
    if (normal.z() > 0) normal = -normal;
    planes.push_back({normal, std::tan(radians(25)), 0});
  }
  const Removability found = removability(planes, true, weight);
  EXPECT_EQ(found.leaving, Leaving::slides_on_two);
  ASSERT_TRUE(found.factor);
  // β, between a bisector upright to the line and the horizontal, is 90° here.
  EXPECT_NEAR(*found.factor, 1 / std::sin(half) * std::tan(radians(25)) / std::tan(plunge), 1e-12);
  EXPECT_LT((found.direction - line).norm(), 1e-12);
}

TEST(Removability, OfAWedgeWithOneSteepPlaneIsSlidingOnTheOther) {
  const std::vector<HoldingPlane> planes{below(30, 0, 20), below(80, 300, 20)};
  const Removability found = removability(planes, true, weight);
  EXPECT_EQ(found.leaving, Leaving::slides_on_one);  // down the dip of the first, away from the second
  EXPECT_THAT(found.on, ElementsAre(0));
  EXPECT_NEAR(found.factor.value(), std::tan(radians(20)) / std::tan(radians(30)), 1e-12);
}

TEST(Removability, OfARoofBlockIsToFall) {
  const std::vector<HoldingPlane> roof{{Vec3(0, 1, 1).normalized(), 0.5, 0},
                                       {Vec3(0, -1, 1).normalized(), 0.5, 0},
                                       {Vec3(1, 0, 1).normalized(), 0.5, 0},
                                       {Vec3(-1, 0, 1).normalized(), 0.5, 0}};
  const Removability found = removability(roof, true, weight);
  EXPECT_EQ(found.leaving, Leaving::falls);
  EXPECT_EQ(found.factor, 0);
  EXPECT_THAT(found.on, IsEmpty());
}

/// Between upright joints only cohesion holds a block: F = Σ c A / W.
TEST(Removability, OfAPlugBetweenUprightJointsIsHeldByCohesionAlone) {
  std::vector<HoldingPlane> plug;
  for (const Vec3& normal : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0)})
    plug.push_back({normal, 1, 3e5});
  const Removability found = removability(plug, true, weight);
  EXPECT_EQ(found.leaving, Leaving::falls);
  EXPECT_NEAR(found.factor.value(), 1.2, 1e-12);
}

TEST(Removability, OfAKeystoneThatWidensInwardsIsTapered) {
  const std::vector<HoldingPlane> keystone{{Vec3(0, 1, -1).normalized(), 0, 0},
                                           {Vec3(0, -1, -1).normalized(), 0, 0},
                                           {Vec3(1, 0, -1).normalized(), 0, 0},
                                           {Vec3(-1, 0, -1).normalized(), 0, 0},
                                           {Vec3(0, 0, 1), 0, 0}};
  EXPECT_EQ(removability(keystone, true, weight).leaving, Leaving::tapered);
  EXPECT_EQ(removability(keystone, false, weight).leaving, Leaving::enclosed);
  EXPECT_FALSE(removability(keystone, true, weight).removable());
}

TEST(Removability, OfABlockOnAFloorIsToStay) {
  const std::vector<HoldingPlane> floor{below(0, 0, 30)};
  const Removability found = removability(floor, true, weight);
  EXPECT_EQ(found.leaving, Leaving::stable);
  EXPECT_TRUE(found.removable());
  EXPECT_FALSE(found.factor);
  EXPECT_EQ(removability(floor, true, Vec3::Zero()).leaving, Leaving::stable);
}

/// The direction found is the force's projection: no open direction comes nearer to it.
TEST(Removability, LeavesInTheOpenDirectionNearestToTheForce) {
  const std::vector<HoldingPlane> planes{
      below(50, 20, 0), below(60, 100, 0), {Vec3(0.3, -0.9, 0.3).normalized(), 0, 0}};
  const Removability found = removability(planes, true, weight);
  ASSERT_TRUE(found.removable());
  const double reached = found.direction.dot(weight.normalized());
  for (int dip = -90; dip <= 90; dip += 3)
    for (int turn = 0; turn < 360; turn += 3) {
      const double d = radians(dip), a = radians(turn);
      const Vec3 other(std::cos(d) * std::sin(a), std::cos(d) * std::cos(a), std::sin(d));
      bool open = true;
      for (const HoldingPlane& plane : planes) open = open && plane.normal.dot(other) <= 0;
      if (open) {
        EXPECT_LE(other.dot(weight.normalized()), reached + 1e-12) << dip << ' ' << turn;
      }
    }
}

}  // namespace
}  // namespace talus
