#pragma once

#include <gmock/gmock.h>

#include "effects/effect.hpp"

namespace talus::test {

/// Holds an effect's gradient to central differences of its energy, and its Hessian to those of its gradient, at `d`.
/// `step` [m] is the half width; `tolerance` is relative to the largest entry.
inline void expect_derivatives(const Effect& effect, const Increment& d, double step, double tolerance) {
  const auto n = d.size();
  std::vector<std::pair<int, int>> couplings;
  for (int i = 0; i < n / 3; ++i)
    for (int j = 0; j < i; ++j) couplings.emplace_back(i, j);
  SymmetricBlocks hessian;
  hessian.set_pattern(static_cast<int>(n / 3), couplings);
  effect.add_hessian(d, hessian);

  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(n), slopes(n), column;
  effect.add_gradient(d, Arms::end, gradient);
  Eigen::MatrixXd columns(n, n), differences(n, n);
  for (int i = 0; i < n; ++i) {
    Increment plus = d, minus = d;
    plus[i] += step;
    minus[i] -= step;
    slopes[i] = (effect.energy(plus) - effect.energy(minus)) / (2 * step);
    Eigen::VectorXd upper = Eigen::VectorXd::Zero(n), lower = Eigen::VectorXd::Zero(n);
    effect.add_gradient(plus, Arms::end, upper);
    effect.add_gradient(minus, Arms::end, lower);
    differences.col(i) = (upper - lower) / (2 * step);
    hessian.multiply(Eigen::VectorXd::Unit(n, i), column);
    columns.col(i) = column;
  }
  EXPECT_GT(gradient.norm(), 0) << to_string(effect.kind()) << " exerts no force here: the comparison would be empty";
  EXPECT_LT((slopes - gradient).cwiseAbs().maxCoeff(), tolerance * gradient.cwiseAbs().maxCoeff())
      << to_string(effect.kind());
  const double largest = std::max(columns.cwiseAbs().maxCoeff(), gradient.cwiseAbs().maxCoeff());
  EXPECT_LT((differences - columns).cwiseAbs().maxCoeff(), tolerance * largest) << to_string(effect.kind());
}

/// Holds the derivative of an effect's gradient along `x`, by its Hessian and its unsymmetric part, to the central
/// difference at `d`. `step` is the half width, of `x`; `tolerance` is relative.
inline void expect_tangent_along(const Effect& effect, const Increment& d, const Eigen::VectorXd& x, double step,
                                 double tolerance) {
  const auto gradient = [&](const Increment& at) {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(d.size());
    effect.add_gradient(at, Arms::end, sum);
    return sum;
  };
  const Eigen::VectorXd slope = (gradient(d + step * x) - gradient(d - step * x)) / (2 * step);
  std::vector<std::pair<int, int>> couplings;
  effect.add_couplings(couplings);
  SymmetricBlocks symmetric;
  symmetric.set_pattern(static_cast<int>(d.size() / 3), couplings);
  effect.add_hessian(d, symmetric);
  UnsymmetricBlocks unsymmetric;
  unsymmetric.set_pattern(symmetric.pattern());
  effect.add_unsymmetric(d, Arms::end, unsymmetric);
  Eigen::VectorXd tangent;
  symmetric.multiply(x, tangent);
  UnsymmetricBlocks::add_product(unsymmetric.pairs(), x, tangent);
  EXPECT_LT((tangent - slope).norm(), tolerance * slope.norm()) << to_string(effect.kind());
}

}  // namespace talus::test
