#include "mesh/volume_sum.hpp"

#include <gtest/gtest.h>

namespace talus {
namespace {

BlockSystem blocks_of(std::initializer_list<double> volumes, double solids) {
  BlockSystem system;
  for (const double volume : volumes) system.blocks.emplace_back().volume = volume;
  system.solids_volume = solids;
  return system;
}

TEST(VolumeSum, AddsUpToRounding) {
  EXPECT_TRUE(volume_sum(blocks_of({400, 600}, 1000)).adds_up());
  EXPECT_TRUE(volume_sum(blocks_of({400, 600}, 1000 + 0.9e-3)).adds_up());
  EXPECT_FALSE(volume_sum(blocks_of({400, 600}, 1000 + 1.1e-3)).adds_up());
  EXPECT_FALSE(volume_sum(blocks_of({400, 600}, 999)).adds_up());
}

TEST(VolumeSum, CountsWhatWasLeftOutButNotWhatIsPartOfAnother) {
  BlockSystem system = blocks_of({400, 500}, 1000);
  system.excavated_volume = 90;
  EXPECT_FALSE(volume_sum(system).adds_up());
  system.splinters.resize(2);
  system.splinters[0].volume = 10;
  system.splinters[0].fate = Splinter::Fate::dropped;
  system.splinters[1].volume = 7;
  system.splinters[1].fate = Splinter::Fate::merged;
  EXPECT_TRUE(volume_sum(system).adds_up());
  EXPECT_DOUBLE_EQ(volume_sum(system).left_out, 100);
}

}  // namespace
}  // namespace talus
