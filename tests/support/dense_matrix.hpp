#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>

/// Small matrices of the solver written out, to look at as a whole.
namespace talus::test {

/// n × n, column by column from `blocks.multiply(x, product)`.
template <class Blocks>
Eigen::MatrixXd dense_matrix(const Blocks& blocks, Eigen::Index n) {
  Eigen::MatrixXd dense(n, n);
  Eigen::VectorXd column;
  for (Eigen::Index i = 0; i < n; ++i) {
    blocks.multiply(Eigen::VectorXd::Unit(n, i), column);
    dense.col(i) = column;
  }
  return dense;
}

/// Whether a symmetric matrix has no eigenvalue below −1e-10 of its largest entry: raised by that much it has a
/// Cholesky factor.
inline bool has_no_negative_eigenvalue(Eigen::MatrixXd dense) {
  dense.diagonal().array() += 1e-10 * dense.diagonal().maxCoeff();
  return dense.llt().info() == Eigen::Success;
}

}  // namespace talus::test
