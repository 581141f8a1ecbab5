#include "linear/unsymmetric_blocks.hpp"

#include <gmock/gmock.h>

namespace talus {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

const Mat3 lopsided = (Mat3() << 1, 2, 3, 4, 5, 6, 7, 8, 9).finished();

TEST(UnsymmetricBlocks, KeepsBothTrianglesApartAndHoldsOnlyWhatWasAddedTo) {
  UnsymmetricBlocks blocks;
  blocks.set_pattern(BlockPattern(3, {{0, 1}, {1, 2}}));
  blocks.add(0, 1, lopsided);
  blocks.add(1, 0, 10 * lopsided);
  blocks.add(0, 1, lopsided);
  blocks.add(2, 2, lopsided);
  EXPECT_THAT(blocks.pairs(), SizeIs(2));
  Eigen::MatrixXd wanted = Eigen::MatrixXd::Zero(9, 9);
  wanted.block<3, 3>(0, 3) = 2 * lopsided;
  wanted.block<3, 3>(3, 0) = 10 * lopsided;
  wanted.block<3, 3>(6, 6) = lopsided;
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(9, -1, 3);
  Eigen::VectorXd y = x;
  UnsymmetricBlocks::add_product(blocks.pairs(), x, y);
  EXPECT_LT((y - x - wanted * x).norm(), 1e-13);
}

TEST(UnsymmetricBlocks, IsEmptyAgainOnceSetToZero) {
  UnsymmetricBlocks blocks;
  blocks.set_pattern(BlockPattern(2, {{0, 1}}));
  EXPECT_THAT(blocks.pairs(), IsEmpty());
  blocks.add(0, 1, lopsided);
  blocks.set_zero();
  EXPECT_THAT(blocks.pairs(), IsEmpty());
  blocks.add(1, 0, lopsided);
  EXPECT_EQ(blocks.pairs()[0].below, lopsided);
  EXPECT_EQ(blocks.pairs()[0].above, Mat3::Zero());
}

}  // namespace
}  // namespace talus
