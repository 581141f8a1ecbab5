#include "orientation/joint_outline.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "orientation/attitude.hpp"
#include "orientation/drawn_planes.hpp"

namespace talus {
namespace {

Vec3 area_of(const std::vector<Vec3>& corners) {
  Vec3 area = Vec3::Zero();
  for (std::size_t k = 0; k < corners.size(); ++k)
    area += (corners[k] - corners[0]).cross(corners[(k + 1) % corners.size()] - corners[0]) / 2;
  return area;
}

TEST(JointOutline, OfADiscHasItsAreaAndLiesOnItsPlane) {
  Cut cut;
  cut.dip = 50;
  cut.dip_direction = 200;
  cut.disc = {{100, 200, 300}, 7};
  cut.through = cut.disc->centre;
  const std::vector<Vec3> corners = outline_of(cut);
  ASSERT_GE(corners.size(), 24u);
  EXPECT_NEAR(area_of(corners).norm(), std::numbers::pi * 49, 1e-9);
  EXPECT_NEAR(std::abs(area_of(corners).normalized().dot(pole_of({50, 200}))), 1, 1e-12);
  for (const Vec3& corner : corners) {
    EXPECT_NEAR(pole_of({50, 200}).dot(corner - cut.through), 0, 1e-9);
    EXPECT_NEAR((corner - cut.through).norm(), 7, 0.05);
  }
}

TEST(JointOutline, OfAPolygonIsPutOntoThePlaneAlongItsNormal) {
  Cut cut;
  cut.polygon = {{0, 0, 1}, {4, 0, -1}, {4, 4, 1}, {0, 4, -1}};
  cut.through = {2, 2, 0};
  EXPECT_EQ(outline_of(cut), (std::vector<Vec3>{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}));
}

TEST(JointOutline, OfAPlaneWithoutEndIsEmpty) { EXPECT_TRUE(outline_of(Cut()).empty()); }

TEST(JointOutline, OfASetMovesAlongTheNormal) {
  Cut cut;
  cut.disc = {{1, 2, 3}, 2};
  cut.through = cut.disc->centre;
  cut.spacing = 5;
  cut.count = 2;
  const std::vector<Cut> planes = single_planes(cut);
  ASSERT_EQ(planes.size(), 2u);
  EXPECT_EQ(planes[1].disc->centre, Vec3(1, 2, 8));
  EXPECT_EQ(planes[1].disc->radius, 2);
  cut.disc.reset();
  cut.polygon = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_EQ(single_planes(cut)[1].polygon[2], Vec3(0, 1, 5));
}

}  // namespace
}  // namespace talus
