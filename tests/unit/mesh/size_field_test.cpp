#include "mesh/size_field.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace talus {
namespace {

TEST(SizeField, GrowsOverOneMoreRadius) {
  const std::array<MeshRefinement, 1> near{{{Vec3(1, 0, 0), 2, 0.5}}};
  EXPECT_EQ(size_at({1, 0, 0}, 4, near), 0.5);
  EXPECT_EQ(size_at({3, 0, 0}, 4, near), 0.5);
  EXPECT_DOUBLE_EQ(size_at({4, 0, 0}, 4, near), 0.5 + 3.5 / 2);
  EXPECT_EQ(size_at({5, 0, 0}, 4, near), 4);
  EXPECT_EQ(size_at({9, 0, 0}, 4, near), 4);
  EXPECT_EQ(largest_size(4, near), 4);
  EXPECT_EQ(largest_size(0.2, near), 0.5);
}

TEST(SizeField, GoesByTheDistanceToAFaceAndNotToItsPlane) {
  // An L in the plane x + z = 4, which is not convex.
  const double slope = std::sqrt(0.5);
  const auto at = [&](double along, double across, double above) {
    return Vec3(4 - slope * along + slope * above, across, slope * along + slope * above);
  };
  const std::array<MeshRefinement, 1> near{
      {{.radius = 1,
        .size = 0.5,
        .face = {at(0, 0, 0), at(4, 0, 0), at(4, 1, 0), at(1, 1, 0), at(1, 4, 0), at(0, 4, 0)}}}};
  EXPECT_DOUBLE_EQ(size_at(at(0.5, 0.5, 0), 2.5, near), 0.5);
  EXPECT_DOUBLE_EQ(size_at(at(0.5, 3, 0.9), 2.5, near), 0.5) << "above it";
  EXPECT_NEAR(size_at(at(3, 0.5, -1.5), 2.5, near), 1.5, 1e-9) << "below it, half way out of its reach";
  EXPECT_NEAR(size_at(at(2.5, 2.5, 0), 2.5, near), 1.5, 1e-9) << "in the angle of the L, 1.5 m from its sides";
  EXPECT_NEAR(size_at(at(5.5, 0.5, 0), 2.5, near), 1.5, 1e-9) << "in its plane, beyond its end";
  EXPECT_EQ(size_at(at(3.5, 3.5, 0), 2.5, near), 2.5);
}

TEST(SizeField, IsTheSmallestOfThoseThatReachAPoint) {
  const std::array<MeshRefinement, 2> both{{{Vec3(0, 0, 0), 2, 8}, {Vec3(1, 0, 0), 1, 0.5}}};
  EXPECT_EQ(size_at({-1.5, 0, 0}, 4, both), 8) << "coarser than the block's own";
  EXPECT_EQ(size_at({1, 0, 0}, 4, both), 0.5);
}

}  // namespace
}  // namespace talus
