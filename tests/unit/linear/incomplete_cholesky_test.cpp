#include "linear/incomplete_cholesky.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "linear/gmres.hpp"

namespace talus {
namespace {

constexpr int wide = 12;

/// Springs between neighbours of a net of wide × wide nodes, each held by one of its own.
SymmetricBlocks net(double held, double spring_across = 1) {
  SymmetricBlocks matrix;
  std::vector<std::pair<int, int>> couplings;
  for (int i = 0; i < wide * wide; ++i) {
    if (i % wide > 0) couplings.emplace_back(i, i - 1);
    if (i >= wide) couplings.emplace_back(i, i - wide);
  }
  matrix.set_pattern(wide * wide, couplings);
  for (int i = 0; i < wide * wide; ++i) matrix.add(i, i, held * Mat3::Identity());
  const Mat3 spring = (Mat3() << 2, 0.5, 0, 0.5, 1, 0.2, 0, 0.2, 3).finished();
  for (const auto& [i, j] : couplings) {
    const Mat3 k = (i - j == 1 ? 1 : spring_across) * spring;
    matrix.add(i, i, k);
    matrix.add(j, j, k);
    matrix.add(i, j, -k);
  }
  return matrix;
}

TEST(IncompleteCholesky, IsTheWholeFactorWhereNothingIsLeftOut) {
  const SymmetricBlocks rows = net(0.1, 0);  // chains
  IncompleteCholesky factor;
  ASSERT_TRUE(factor.factor(rows));
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(3 * wide * wide, -1, 2);
  Eigen::VectorXd x, back;
  factor.solve(b, x);
  rows.multiply(x, back);
  EXPECT_LT((back - b).norm(), 1e-12 * b.norm());
}

TEST(IncompleteCholesky, SparesMostIterationsOfGmres) {
  const SymmetricBlocks matrix = net(0.01);
  IncompleteCholesky factor;
  ASSERT_TRUE(factor.factor(matrix));
  Eigen::VectorXd b(3 * wide * wide);
  for (int i = 0; i < b.size(); ++i) b[i] = std::sin(double(i) * i);  // every wavelength
  const auto apply = [&](const Eigen::VectorXd& from, Eigen::VectorXd& to) { matrix.multiply(from, to); };
  Gmres gmres;
  Eigen::VectorXd x;
  const int plain = gmres.solve(
      apply, [](const Eigen::VectorXd& from, Eigen::VectorXd& to) { to = from; }, b, x, 1e-6, 200);
  const int with = gmres.solve(
      apply, [&](const Eigen::VectorXd& from, Eigen::VectorXd& to) { factor.solve(from, to); }, b, x, 1e-6, 200);
  EXPECT_LT(2 * with, plain);
}

/// A ring of springs that turn what they pull into its opposite is barely definite: what is left out of its factor
/// makes it indefinite.
TEST(IncompleteCholesky, EnlargesADiagonalThatIsTooSmallAndRefusesWhatIsIndefinite) {
  SymmetricBlocks ring;
  ring.set_pattern(4, {{1, 0}, {2, 0}, {3, 1}, {3, 2}});
  for (int i = 0; i < 4; ++i) ring.add(i, i, 1.42 * Mat3::Identity());
  for (const auto& [i, j] : {std::pair{1, 0}, std::pair{2, 0}, std::pair{3, 1}}) ring.add(i, j, Mat3::Identity());
  ring.add(3, 2, -Mat3::Identity());
  IncompleteCholesky factor;
  EXPECT_TRUE(factor.factor(ring));
  ring.add(2, 2, -10 * Mat3::Identity());
  EXPECT_FALSE(factor.factor(ring));
}

}  // namespace
}  // namespace talus
