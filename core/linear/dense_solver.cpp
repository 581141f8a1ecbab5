#include "linear/dense_solver.hpp"

#include "linear/not_positive_definite.hpp"

namespace talus {

namespace {

/// The node at which the leading part of a matrix ceases to be positive definite.
int first_indefinite_node(const Eigen::MatrixXd& matrix) {
  int node = 0;
  while (matrix.topLeftCorner(3 * node + 3, 3 * node + 3).llt().info() == Eigen::Success) ++node;
  return node;
}

}  // namespace

void DenseSolver::factor(const SymmetricBlocks& matrix, std::span<const UnsymmetricBlocks::Pair> unsymmetric,
                         std::span<const int> nodes) {
  const auto size = static_cast<Eigen::Index>(3 * nodes.size());
  number_.resize(matrix.nodes());
  for (std::size_t k = 0; k < nodes.size(); ++k) number_[nodes[k]] = static_cast<int>(k);
  const auto is_among = [&](int node) {
    return static_cast<std::size_t>(number_[node]) < nodes.size() && nodes[number_[node]] == node;
  };
  const BlockPattern& pattern = matrix.pattern();
  full_.setZero(size, size);
  for (const int column : nodes)
    for (int slot = pattern.column_begin()[column]; slot < pattern.column_begin()[column + 1]; ++slot) {
      if (!is_among(pattern.rows()[slot])) continue;
      const int i = 3 * number_[pattern.rows()[slot]], j = 3 * number_[column];
      full_.block<3, 3>(j, i) = matrix.value(slot).transpose();
      full_.block<3, 3>(i, j) = matrix.value(slot);
    }
  cholesky_.compute(full_);
  if (cholesky_.info() != Eigen::Success) throw NotPositiveDefinite(nodes[first_indefinite_node(full_)]);
  is_symmetric_ = true;
  for (const UnsymmetricBlocks::Pair& pair : unsymmetric) {
    if (!is_among(pair.row) || !is_among(pair.column)) continue;
    const int i = 3 * number_[pair.row], j = 3 * number_[pair.column];
    full_.block<3, 3>(i, j) += pair.below;
    full_.block<3, 3>(j, i) += pair.above;
    is_symmetric_ = false;
  }
  if (!is_symmetric_) lu_.compute(full_);
}

void DenseSolver::solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) const {
  if (is_symmetric_) {
    x = b;
    cholesky_.solveInPlace(x);
  } else {
    x.noalias() = lu_.solve(b);
  }
}

}  // namespace talus
