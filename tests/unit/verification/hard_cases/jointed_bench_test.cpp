#include "verification/hard_cases/scenes/jointed_bench.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/block_builder.hpp"

namespace talus {
namespace {

constexpr double bench_volume = 40 * 40 * 12;  // m³

BlockSystem blocks_of(const JointedBench& bench) {
  NoProgress nobody;
  return build_blocks(bench.project(), {}, nobody);
}

/// What another language's Mersenne Twister of the same seed draws.
TEST(JointedBench, IsTheSameForTheSameSeedWhereverItIsDrawn) {
  const JointedBench first{.seed = 1}, seventh{.seed = 7, .end = BenchEnd::stands};
  EXPECT_DOUBLE_EQ(first.dip(), 27.687284882248026);
  EXPECT_DOUBLE_EQ(first.friction_angle(), 22.403810117027962);
  EXPECT_DOUBLE_EQ(seventh.friction_angle(), 41.476655296663246);
  const Cut south = first.project().cuts[1], east = seventh.project().cuts[2];
  EXPECT_DOUBLE_EQ(south.dip_direction, 200.84602421623396);
  EXPECT_NEAR(*south.spacing, 6.990870174183883, 1e-12);
  EXPECT_EQ(south.count, 5);
  EXPECT_DOUBLE_EQ(east.dip, 61.62396989369179);
  EXPECT_NEAR(east.through.x(), -2.893265871466748, 1e-12);
  EXPECT_EQ(east.count, 7);
}

TEST(JointedBench, SlidesOrStandsByItsFriction) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const JointedBench slides{.seed = seed}, stands{.seed = seed, .end = BenchEnd::stands};
    EXPECT_TRUE(slides.dip() >= 25 && slides.dip() <= 45) << slides.dip();
    EXPECT_LE(slides.friction_angle(), slides.dip() - 5);
    EXPECT_GE(slides.friction_angle(), slides.dip() - 15);
    EXPECT_DOUBLE_EQ(stands.friction_angle(), stands.dip() + 10);
    EXPECT_EQ(stands.project().cuts, slides.project().cuts);
  }
}

TEST(JointedBench, HasMoreBlocksThanTheSquareOfItsPlanesAndFewerThanTheCube) {
  for (const int planes : {5, 6, 9}) {
    const BlockSystem system = blocks_of({.planes = planes, .seed = 3});
    const int moving = static_cast<int>(system.blocks.size()) - 1, square = planes * planes;
    EXPECT_TRUE(moving > square && moving < square * planes) << moving;
  }
}

/// Nothing of the bench is lost but splinters.
TEST(JointedBench, BlocksHaveItsVolume) {
  for (const BodyKind body : {BodyKind::rigid, BodyKind::tetrahedra}) {
    double sum = 0;
    const BlockSystem system = blocks_of({.seed = 9, .body = body});
    for (const Splinter& splinter : system.splinters) sum += splinter.volume;
    EXPECT_LT(sum, 1e-8 * bench_volume);
    for (const Block& block : system.blocks) {
      EXPECT_EQ(block.body, block.name == "bedrock" ? BodyKind::fixed : body);
      if (block.body != BodyKind::fixed) sum += block.volume;
    }
    EXPECT_NEAR(sum, bench_volume, 1e-9 * bench_volume);
  }
}

TEST(JointedBench, BlocksAreTheSameEveryTime) {
  const JointedBench bench{.seed = 2, .body = BodyKind::tetrahedra};
  const BlockSystem once = blocks_of(bench), again = blocks_of(bench);
  ASSERT_EQ(once.blocks.size(), again.blocks.size());
  for (std::size_t b = 0; b < once.blocks.size(); ++b) {
    EXPECT_EQ(once.blocks[b].name, again.blocks[b].name);
    EXPECT_EQ(once.blocks[b].mesh.nodes, again.blocks[b].mesh.nodes) << once.blocks[b].name;
  }
}

}  // namespace
}  // namespace talus
