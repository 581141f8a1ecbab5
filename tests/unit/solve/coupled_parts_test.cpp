#include "solve/coupled_parts.hpp"

#include <gmock/gmock.h>

namespace talus {
namespace {

using testing::ElementsAre;

TEST(CoupledParts, nodes_go_together_where_a_value_is_not_zero) {
  SymmetricBlocks matrix;
  matrix.set_pattern(6, {{0, 3}, {1, 3}, {2, 5}, {4, 5}});
  UnsymmetricBlocks beyond;
  beyond.set_pattern(matrix.pattern());
  CoupledParts parts;
  parts.find(matrix, beyond.pairs());
  EXPECT_EQ(parts.count(), 6) << "nothing has a value";

  matrix.add(0, 3, 1e-300 * Mat3::Identity());
  beyond.add(2, 5, Mat3::Identity());
  parts.find(matrix, beyond.pairs());
  ASSERT_EQ(parts.count(), 4);
  EXPECT_THAT(parts.nodes(0), ElementsAre(0, 3));
  EXPECT_THAT(parts.nodes(1), ElementsAre(1));
  EXPECT_THAT(parts.nodes(2), ElementsAre(2, 5));
  EXPECT_THAT(parts.nodes(3), ElementsAre(4));
  EXPECT_EQ(parts.couplings(0), 1);
  EXPECT_EQ(parts.couplings(1), 0);
  EXPECT_EQ(parts.couplings(2), 0) << "only beyond the symmetric matrix";
}

}  // namespace
}  // namespace talus
