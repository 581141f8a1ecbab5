#include "mesh/size_field.hpp"

#include <gtest/gtest.h>

#include <array>

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

TEST(SizeField, IsTheSmallestOfThoseThatReachAPoint) {
  const std::array<MeshRefinement, 2> both{{{Vec3(0, 0, 0), 2, 8}, {Vec3(1, 0, 0), 1, 0.5}}};
  EXPECT_EQ(size_at({-1.5, 0, 0}, 4, both), 8) << "coarser than the block's own";
  EXPECT_EQ(size_at({1, 0, 0}, 4, both), 0.5);
}

}  // namespace
}  // namespace talus
