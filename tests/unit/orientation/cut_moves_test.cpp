#include "orientation/cut_moves.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace talus {
namespace {

Cut plane() {
  Cut cut;
  cut.joint = "J1";
  cut.dip = 45;
  cut.dip_direction = 90;
  cut.through = {1, 2, 3};
  return cut;
}

TEST(CutMoves, AlongTheNormalGoUp) {
  const Cut up = moved(plane(), std::sqrt(2.0));
  EXPECT_TRUE(up.through.isApprox(Vec3(2, 2, 4))) << up.through.transpose();
  EXPECT_EQ(up.dip, 45);
  EXPECT_EQ(moved(plane(), 0), plane());
}

TEST(CutMoves, TakeDiscsPolygonsAndNetworksAlong) {
  Cut disc = plane(), polygon = plane(), network = plane();
  disc.disc = Disc{disc.through, 4};
  polygon.polygon = {{0, 0, 4}, {2, 0, 2}, {2, 6, 2}, {0, 6, 4}};
  polygon.through = {1, 3, 3};
  network.network = JointNetwork{{{0, 0, 0}, {2, 4, 6}}, 1, 1};
  const double by = std::sqrt(2.0);
  EXPECT_TRUE(moved(disc, by).disc->centre.isApprox(Vec3(2, 2, 4)));
  EXPECT_TRUE(moved(polygon, by).polygon[1].isApprox(Vec3(3, 0, 3)));
  EXPECT_TRUE(moved(polygon, by).through.isApprox(Vec3(2, 3, 4)));
  EXPECT_TRUE(moved(network, by).network->box.max.isApprox(Vec3(3, 4, 7)));
  EXPECT_TRUE(moved(network, by).through.isApprox(Vec3(2, 2, 4)));
}

TEST(CutMoves, TurnAboutThePivot) {
  const Vec3 pivot(0, 7, 4);  // of the same plane
  const Cut flat = turned(plane(), {0, 90}, pivot);
  EXPECT_EQ(flat.dip, 0);
  EXPECT_EQ(flat.through, pivot);
  Cut polygon = plane();
  polygon.polygon = {{0, 0, 4}, {2, 0, 2}, {2, 6, 2}, {0, 6, 4}};
  polygon.through = {1, 3, 3};
  const Cut level = turned(polygon, {0, 90}, polygon.through);
  for (const Vec3& corner : level.polygon) EXPECT_NEAR(corner.z(), 3, 1e-3);
  EXPECT_NEAR((level.polygon[1] - level.polygon[0]).norm(), std::sqrt(8.0), 2e-3) << "it keeps its shape";
  EXPECT_TRUE(level.through.isApprox(polygon.through, 1e-3));
}

TEST(CutMoves, OfACornerStayInThePlane) {
  Cut polygon = plane();
  polygon.polygon = {{0, 0, 4}, {2, 0, 2}, {2, 6, 2}};
  polygon.through = {4.0 / 3, 2, 8.0 / 3};
  const Cut wider = with_corner(polygon, 2, {4, 9, 4});
  EXPECT_NEAR(normal_of(wider).dot(wider.polygon[2] - polygon.through), 0, 1e-3);
  EXPECT_NEAR(wider.polygon[2].y(), 9, 1e-9);
  EXPECT_EQ(wider.polygon[0], polygon.polygon[0]);
}

}  // namespace
}  // namespace talus
