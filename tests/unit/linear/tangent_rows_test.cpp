// Products of a tangent that is stored row by row.
#include "linear/tangent_rows.hpp"

#include <gtest/gtest.h>

#include "base/parallel.hpp"

namespace talus {
namespace {

constexpr int row_count = 2500;

TEST(TangentRows, MultiplyAsTheirTwoPartsDoToTheSameBitsOnAnyNumberOfCores) {
  std::vector<std::pair<int, int>> couplings;
  for (int node = 0; node < row_count; ++node)
    for (const int other : {node + 1, node + 40, node + 41})
      if (other < row_count) couplings.emplace_back(node, other);
  SymmetricBlocks matrix;
  matrix.set_pattern(row_count, couplings);
  UnsymmetricBlocks unsymmetric;
  unsymmetric.set_pattern(matrix.pattern());
  const Mat3 block = (Mat3() << 2, 0.5, 0, 0.1, 1, 0.2, 0, -0.4, 3).finished();
  for (int node = 0; node < row_count; ++node) matrix.add(node, node, (4 + 0.01 * node) * Mat3::Identity());
  for (std::size_t k = 0; k < couplings.size(); ++k) {
    const auto [a, b] = couplings[k];
    if (k % 3 > 0) matrix.add(a, b, block);  // every third is zero
    if (k % 4 == 0) unsymmetric.add(a, b, 0.3 * block);
    if (k % 5 == 0) unsymmetric.add(b, a, -0.2 * block);
    if (k % 7 == 0) unsymmetric.add(a, a, block);
  }
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(3 * row_count, -1, 2);
  Eigen::VectorXd expected, y, on_several;
  matrix.multiply(x, expected);
  UnsymmetricBlocks::add_product(unsymmetric.pairs(), x, expected);
  TangentRows rows;
  rows.set(matrix, unsymmetric.pairs());
  rows.multiply(x, y);
  EXPECT_LT((y - expected).norm(), 1e-14 * expected.norm());
  const ThreadLimit limit(3);
  rows.multiply(x, on_several);
  EXPECT_EQ(on_several, y);
}

}  // namespace
}  // namespace talus
