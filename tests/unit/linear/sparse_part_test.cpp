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
    part.take(matrix, unsymmetric.pairs(), nodes);
    Eigen::VectorXd x;
    LinearWork work;
    part.solve(b, {.tolerance = 1e-12, .limit = 40}, work, x);
    EXPECT_GT(work.gmres_iterations, 0) << "it has an unsymmetric part";

    Eigen::VectorXd whole = Eigen::VectorXd::Zero(3 * all), forces;
    for (Eigen::Index k = 0; k < count; ++k) whole.segment<3>(3 * nodes[k]) = x.segment<3>(3 * k);
    matrix.multiply(whole, forces);
    UnsymmetricBlocks::add_product(unsymmetric.pairs(), whole, forces);
    for (Eigen::Index k = 0; k < count; ++k)
      EXPECT_LT((forces.segment<3>(3 * nodes[k]) - b.segment<3>(3 * k)).norm(), 1e-10) << nodes[k];
  }
}

TEST(SparsePart, NeedsNoWholeFactorWhereItsNodesAreMany) {
  constexpr int many = 800;
  SymmetricBlocks matrix;
  std::vector<std::pair<int, int>> couplings;
  for (int node = 1; node < many; ++node) couplings.emplace_back(node, node - 1);
  for (int node = 30; node < many; ++node) couplings.emplace_back(node, node - 30);
  matrix.set_pattern(many, couplings);
  for (int node = 0; node < many; ++node) matrix.add(node, node, 5 * Mat3::Identity());
  for (const auto& [a, b] : couplings) matrix.add(a, b, -Mat3::Identity());
  std::vector<int> nodes;
  for (int node = 100; node < many; ++node) nodes.push_back(node);
  SparsePart part;
  part.take(matrix, {}, nodes);
  const Eigen::VectorXd b = Eigen::VectorXd::Ones(3 * static_cast<Eigen::Index>(nodes.size()));
  Eigen::VectorXd x, exact;
  LinearWork work;
  part.solve(b, {.tolerance = 1e-6, .limit = 40, .incomplete_limit = 40}, work, x);
  EXPECT_EQ(work.factorisations, 0);
  EXPECT_GT(work.gmres_iterations, 0);
  part.solve(b, {.tolerance = 1e-6, .limit = 40, .incomplete_limit = 1}, work, exact);
  EXPECT_EQ(work.factorisations, 1) << "one iteration is not enough";
  EXPECT_LT((x - exact).norm(), 1e-6 * exact.norm());
}

TEST(SparsePart, TellsWhichNodeOfTheMatrixIsHeldByNothing) {
  SymmetricBlocks matrix = springs();
  matrix.add(20, 20, -20 * Mat3::Identity());
  SparsePart part;
  part.take(matrix, {}, std::vector{2, 3, 20});
  LinearWork work;
  Eigen::VectorXd x;
  try {
    part.solve(Eigen::VectorXd::Ones(9), {.tolerance = 1e-12, .limit = 40}, work, x);
    FAIL() << "it is not positive definite";
  } catch (const NotPositiveDefinite& error) {
    EXPECT_EQ(error.node, 20);
  }
}

}  // namespace
}  // namespace talus
