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

}  // namespace
}  // namespace talus
