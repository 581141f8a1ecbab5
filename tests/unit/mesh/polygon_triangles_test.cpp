#include "mesh/polygon_triangles.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace talus {
namespace {

/// An arrow head: its notch lies in the triangle of its three other corners.
TEST(PolygonTriangles, KeepOutOfANotch) {
  const std::vector<Vec3> corners{{0, 0, 0}, {2, 1, 0}, {0, 2, 0}, {1, 1, 0}};
  double area = 0;
  for (const auto& [a, b, c] : polygon_triangles(corners, {0, 1, 2, 3})) {
    const double one = (corners[b] - corners[a]).cross(corners[c] - corners[a]).z() / 2;
    EXPECT_GT(one, 0);
    area += one;
  }
  EXPECT_DOUBLE_EQ(area, 1);
}

}  // namespace
}  // namespace talus
