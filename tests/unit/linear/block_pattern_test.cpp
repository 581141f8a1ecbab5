#include "linear/block_pattern.hpp"

#include <gmock/gmock.h>

namespace talus {
namespace {

using testing::ElementsAre;

TEST(BlockPattern, HoldsEachPairOnceAndTheDiagonalFirst) {
  const BlockPattern pattern(4, {{2, 0}, {0, 2}, {3, 1}, {1, 1}});
  EXPECT_EQ(pattern.nodes(), 4);
  EXPECT_THAT(pattern.column_begin(), ElementsAre(0, 2, 4, 5, 6));
  EXPECT_THAT(pattern.rows(), ElementsAre(0, 2, 1, 3, 2, 3));
  EXPECT_EQ(pattern.slot(0, 2), 1);
  EXPECT_EQ(pattern.slot(2, 0), 1);
  EXPECT_EQ(pattern.slot(3, 3), 5);
}

TEST(BlockPattern, PartIsThePatternOfItsNodesAlone) {
  const BlockPattern pattern(4, {{2, 0}, {3, 1}});
  const std::vector<int> local{0, 0, 1, 1};
  EXPECT_EQ(pattern.part(std::vector{0, 2}, local), BlockPattern(2, {{0, 1}}));
  EXPECT_EQ(pattern.part(std::vector{1, 3}, local), BlockPattern(2, {{0, 1}}));
}

}  // namespace
}  // namespace talus
