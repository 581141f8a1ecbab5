// Some nodes of a matrix solved with all others held.
#include "linear/sparse_part.hpp"

#include <gtest/gtest.h>

namespace talus {
namespace {

constexpr int all = 30;

/// Springs from each node to the next and to the fourth after it, each node held by one of its own.
SymmetricBlocks springs() {
  std::vector<std::pair<int, int>> couplings;
  for (int node = 0; node < all; ++node)
    for (const int other : {node + 1, node + 4})
      if (other < all) couplings.emplace_back(node, other);
  SymmetricBlocks matrix;
  matrix.set_pattern(all, couplings);
  for (int node = 0; node < all; ++node) matrix.add(node, node, (5 + 0.1 * node) * Mat3::Identity());
  for (const auto& [a, b] : couplings) matrix.add(a, b, -Mat3::Identity() + 0.01 * a * Mat3::Ones());
  return matrix;
}

TEST(SparsePart, SolvesItsNodesWithTheOthersHeld) {
  const SymmetricBlocks matrix = springs();
  UnsymmetricBlocks unsymmetric;
  unsymmetric.set_pattern(matrix.pattern());
  const Mat3 block = (Mat3() << 0, 0.2, 0, 0.1, 0, 0, 0.3, 0, 0).finished();
  unsymmetric.add(3, 2, block);
  unsymmetric.add(11, 7, block);  // 11 is held
  for (const std::vector<int>& nodes : {std::vector{2, 3, 7, 8, 20}, std::vector{0, 1, 2, 3, 4, 5, 6, 7}}) {
    const auto count = static_cast<Eigen::Index>(nodes.size());
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(3 * count, 1, 2);
    SparsePart part;
    part.factor(matrix, unsymmetric.pairs(), nodes);
    Eigen::VectorXd x;
    EXPECT_GT(part.solve(b, {.tolerance = 1e-12, .limit = 40}, x), 0) << "it has an unsymmetric part";

    Eigen::VectorXd whole = Eigen::VectorXd::Zero(3 * all), forces;
    for (Eigen::Index k = 0; k < count; ++k) whole.segment<3>(3 * nodes[k]) = x.segment<3>(3 * k);
    matrix.multiply(whole, forces);
    UnsymmetricBlocks::add_product(unsymmetric.pairs(), whole, forces);
    for (Eigen::Index k = 0; k < count; ++k)
      EXPECT_LT((forces.segment<3>(3 * nodes[k]) - b.segment<3>(3 * k)).norm(), 1e-10) << nodes[k];
  }
}

TEST(SparsePart, TellsWhichNodeOfTheMatrixIsHeldByNothing) {
  SymmetricBlocks matrix = springs();
  matrix.add(20, 20, -20 * Mat3::Identity());
  SparsePart part;
  try {
    part.factor(matrix, {}, std::vector{2, 3, 20});
    FAIL() << "it is not positive definite";
  } catch (const NotPositiveDefinite& error) {
    EXPECT_EQ(error.node, 20);
  }
}

}  // namespace
}  // namespace talus
