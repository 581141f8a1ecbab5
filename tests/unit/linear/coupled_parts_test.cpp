#include "linear/coupled_parts.hpp"

#include <gmock/gmock.h>

namespace talus {
namespace {

using testing::ElementsAre;

TEST(CoupledParts, NodesGoTogetherWhereAValueIsNotZero) {
  SymmetricBlocks matrix;
  matrix.set_pattern(6, {{0, 3}, {1, 3}, {2, 5}, {4, 5}});
  UnsymmetricBlocks unsymmetric;
  unsymmetric.set_pattern(matrix.pattern());
  CoupledParts parts;
  parts.find(matrix, unsymmetric.pairs());
  EXPECT_EQ(parts.count(), 6) << "nothing has a value";

  matrix.add(0, 3, 1e-300 * Mat3::Identity());
  unsymmetric.add(2, 5, Mat3::Identity());
  parts.find(matrix, unsymmetric.pairs());
  ASSERT_EQ(parts.count(), 4);
  EXPECT_THAT(parts.nodes(0), ElementsAre(0, 3));
  EXPECT_THAT(parts.nodes(1), ElementsAre(1));
  EXPECT_THAT(parts.nodes(2), ElementsAre(2, 5));
  EXPECT_THAT(parts.nodes(3), ElementsAre(4));
  EXPECT_EQ(parts.couplings(0), 1);
  EXPECT_EQ(parts.couplings(1), 0);
  EXPECT_EQ(parts.couplings(2), 0) << "only in the unsymmetric part";
}

}  // namespace
}  // namespace talus
