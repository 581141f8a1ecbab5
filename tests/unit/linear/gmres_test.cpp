#include "linear/gmres.hpp"

#include <gmock/gmock.h>

namespace talus {
namespace {

TEST(Gmres, TakesAsManyIterationsAsThereAreDistinctEigenvalues) {
  const int n = 20;
  Eigen::MatrixXd a = Eigen::MatrixXd::Identity(n, n) * 4;
  Eigen::VectorXd s = Eigen::VectorXd::LinSpaced(n, -1, 2), t = Eigen::VectorXd::LinSpaced(n, 3, 0.5);
  a += s * t.transpose();  // unsymmetric, of rank one
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(n, 1, 7);
  Gmres gmres;
  Eigen::VectorXd x;
  const int iterations = gmres.solve([&](const auto& v, auto& w) { w = a * v; },
                                     [](const auto& v, auto& w) { w = v / 4; }, b, x, 1e-12, 40);
  EXPECT_LE(iterations, 3);
  EXPECT_LT((a * x - b).norm(), 1e-11 * b.norm());
}

TEST(Gmres, SaysThatItDidNotGetThere) {
  const int n = 30;
  Eigen::VectorXd diagonal(n);
  for (int i = 0; i < n; ++i) diagonal[i] = i + 1;
  Gmres gmres;
  Eigen::VectorXd x;
  const auto apply = [&](const Eigen::VectorXd& v, Eigen::VectorXd& w) { w = diagonal.cwiseProduct(v); };
  EXPECT_EQ(gmres.solve(
                apply, [](const auto& v, auto& w) { w = v; }, Eigen::VectorXd::Ones(n), x, 1e-14, 5),
            5);
}

TEST(Gmres, OfNothingMakesNothing) {
  Gmres gmres;
  Eigen::VectorXd x;
  const auto same = [](const Eigen::VectorXd& v, Eigen::VectorXd& w) { w = v; };
  EXPECT_EQ(gmres.solve(same, same, Eigen::VectorXd::Zero(3), x, 1e-9, 10), 0);
  EXPECT_EQ(x.norm(), 0);
}

}  // namespace
}  // namespace talus
