#include "linear/cholesky.hpp"

#include <gmock/gmock.h>

namespace talus {
namespace {

SymmetricBlocks chain(double spring) {
  SymmetricBlocks matrix;
  matrix.set_pattern(3, {{1, 0}, {1, 2}});
  const Mat3 block = spring * (Mat3() << 2, 0.1, 0.2, 0.1, 3, 0.3, 0.2, 0.3, 4).finished();
  for (int i = 0; i < 3; ++i) matrix.add(i, i, 2 * block);
  Mat3 coupling = -0.5 * block;
  coupling(0, 1) += 0.2;  // couplings need not be symmetric in themselves
  matrix.add(0, 1, coupling);
  matrix.add(2, 1, coupling);
  return matrix;
}

TEST(SymmetricBlocks, MultipliesAsTheFullSymmetricMatrix) {
  const SymmetricBlocks matrix = chain(1);
  Eigen::MatrixXd full(9, 9);
  Eigen::VectorXd column;
  for (int i = 0; i < 9; ++i) {
    matrix.multiply(Eigen::VectorXd::Unit(9, i), column);
    full.col(i) = column;
  }
  EXPECT_EQ((full - full.transpose()).norm(), 0);
  EXPECT_NEAR(full(0, 4), -0.05 + 0.2, 1e-15);
  EXPECT_NEAR(full(6, 4), -0.05 + 0.2, 1e-15);
}

TEST(Cholesky, SolvesAndSolvesAgainWithNewValuesOnTheSameAnalysis) {
  Cholesky cholesky;
  cholesky.analyse(chain(1).pattern());
  for (const double spring : {1.0, 7.0}) {
    const SymmetricBlocks matrix = chain(spring);
    cholesky.factor(matrix);
    const Eigen::VectorXd wanted = Eigen::VectorXd::LinSpaced(9, -1, 3);
    Eigen::VectorXd b, x;
    matrix.multiply(wanted, b);
    cholesky.solve(b, x);
    EXPECT_LT((x - wanted).norm(), 1e-13);
  }
}

TEST(Cholesky, RefusesAMatrixThatIsNotPositiveDefinite) {
  SymmetricBlocks matrix = chain(1);
  matrix.add(1, 1, -100 * Mat3::Identity());
  Cholesky cholesky;
  cholesky.analyse(matrix.pattern());
  try {
    cholesky.factor(matrix);
    FAIL() << "it was factored";
  } catch (const NotPositiveDefinite& error) {
    EXPECT_EQ(error.node, 1);
  }
}

}  // namespace
}  // namespace talus
