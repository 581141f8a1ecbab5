#include "linear/sparse_lu.hpp"

#include <gmock/gmock.h>

#include <Eigen/LU>

namespace talus {
namespace {

constexpr int nodes = 5;

/// A ring of nodes, coupled unsymmetrically.
class Ring : public testing::Test {
 protected:
  Ring() {
    std::vector<std::pair<int, int>> couplings;
    for (int node = 0; node < nodes; ++node) couplings.emplace_back(node, (node + 1) % nodes);
    const BlockPattern pattern(nodes, couplings);
    matrix.set_pattern(pattern);
    unsymmetric.set_pattern(pattern);
    for (int node = 0; node < nodes; ++node) {
      matrix.add(node, node, (4.0 + node) * Mat3::Identity());
      matrix.add((node + 1) % nodes, node, Vec3(1, 0.2, -0.4) * Vec3(0.3, -1, 0.5).transpose());
      unsymmetric.add(node, (node + 1) % nodes, Vec3(0.1 * node, 2, 1) * Vec3(1, 0, -0.7).transpose());
      unsymmetric.add(node, node, Vec3(0.5, 0.1, 0) * Vec3(0, 1, 0.3).transpose());
    }
    Eigen::VectorXd column;
    for (int i = 0; i < 3 * nodes; ++i) {
      matrix.multiply(Eigen::VectorXd::Unit(3 * nodes, i), column);
      UnsymmetricBlocks::add_product(unsymmetric.pairs(), Eigen::VectorXd::Unit(3 * nodes, i), column);
      dense.col(i) = column;
    }
  }
  SymmetricBlocks matrix;
  UnsymmetricBlocks unsymmetric;
  Eigen::MatrixXd dense{3 * nodes, 3 * nodes};
  SparseLu lu;
  Eigen::VectorXd x;
};

TEST_F(Ring, IsSolvedAsDensely) {
  ASSERT_TRUE(lu.factor(matrix, unsymmetric.pairs()));
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(3 * nodes, -1, 2);
  lu.solve(b, x);
  EXPECT_LT((x - dense.partialPivLu().solve(b)).norm(), 1e-13 * x.norm());
}

TEST_F(Ring, FactorIsOfTheMatrixGivenLast) {
  ASSERT_TRUE(lu.factor(matrix, unsymmetric.pairs()));
  for (int node = 0; node < nodes; ++node) matrix.add(node, node, Mat3::Identity());
  ASSERT_TRUE(lu.factor(matrix, {}));
  lu.solve(Eigen::VectorXd::Ones(3 * nodes), x);
  Eigen::VectorXd b;
  matrix.multiply(x, b);
  EXPECT_LT((b - Eigen::VectorXd::Ones(3 * nodes)).norm(), 1e-13);
}

TEST_F(Ring, BlocksThatWereZeroMayComeIn) {
  SymmetricBlocks alone;
  alone.set_pattern(matrix.pattern());
  for (int node = 0; node < nodes; ++node) alone.add(node, node, 2 * Mat3::Identity());
  ASSERT_TRUE(lu.factor(alone, {}));
  lu.solve(Eigen::VectorXd::Ones(3 * nodes), x);
  EXPECT_LT((x - 0.5 * Eigen::VectorXd::Ones(3 * nodes)).norm(), 1e-15);
  ASSERT_TRUE(lu.factor(matrix, unsymmetric.pairs()));
  lu.solve(dense * Eigen::VectorXd::Ones(3 * nodes), x);
  EXPECT_LT((x - Eigen::VectorXd::Ones(3 * nodes)).norm(), 1e-13);
}

TEST_F(Ring, SingularMatrixHasNoFactor) {
  matrix.set_zero();
  EXPECT_FALSE(lu.factor(matrix, {}));
}

}  // namespace
}  // namespace talus
