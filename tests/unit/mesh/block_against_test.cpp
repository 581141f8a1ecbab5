#include "mesh/block_against.hpp"

#include <gtest/gtest.h>

#include "support/small_scenes.hpp"

namespace talus {
namespace {

BlockSystem slab_on_a_floor() {
  BlockSystem system;
  system.blocks = {test::box_block("floor", Vec3(-5, -5, -1), Vec3(5, 5, 0)),
                   test::box_block("slab", Vec3(0, 0, 0), Vec3(2, 1, 1))};
  return system;
}

TEST(BlockAgainst, IsFoundFromEitherSide) {
  const BlockSystem system = slab_on_a_floor();
  EXPECT_EQ(block_against(system, 1, {1, 0.5, 0}, -Vec3::UnitZ()), 0);
  EXPECT_EQ(block_against(system, 0, {1, 0.5, 0}, Vec3::UnitZ()), 1);
}

TEST(BlockAgainst, IsNoneOfAFreeFace) {
  const BlockSystem system = slab_on_a_floor();
  EXPECT_EQ(block_against(system, 1, {1, 0.5, 1}, Vec3::UnitZ()), -1);
  EXPECT_EQ(block_against(system, 0, {3, 3, 0}, Vec3::UnitZ()), -1) << "beside the slab";
  EXPECT_EQ(block_against(system, 0, {1, 0.5, 0}, -Vec3::UnitZ()), -1) << "from the wrong side";
  EXPECT_EQ(block_against(system, 1, {1, 0.5, -0.01}, -Vec3::UnitZ()), -1) << "a gap";
}

}  // namespace
}  // namespace talus
