#include "solve/dense_solver.hpp"

#include "solve/not_positive_definite.hpp"

namespace talus {

namespace {

/// The node at which the leading part of a matrix ceases to be positive definite.
int first_indefinite_node(const Eigen::MatrixXd& matrix) {
  int node = 0;
  while (matrix.topLeftCorner(3 * node + 3, 3 * node + 3).llt().info() == Eigen::Success) ++node;
  return node;
}

}  // namespace

void DenseSolver::factor(const SymmetricBlocks& matrix, std::span<const UnsymmetricBlocks::Pair> beyond) {
  const BlockPattern& pattern = matrix.pattern();
  full_.setZero(3 * matrix.nodes(), 3 * matrix.nodes());
  for (int column = 0; column < matrix.nodes(); ++column)
    for (int slot = pattern.column_begin()[column]; slot < pattern.column_begin()[column + 1]; ++slot) {
      const int row = pattern.rows()[slot];
      full_.block<3, 3>(3 * column, 3 * row) = matrix.value(slot).transpose();
      full_.block<3, 3>(3 * row, 3 * column) = matrix.value(slot);
    }
  symmetric_.compute(full_);
  if (symmetric_.info() != Eigen::Success) throw NotPositiveDefinite(first_indefinite_node(full_));
  is_symmetric_ = beyond.empty();
  if (is_symmetric_) return;
  for (const UnsymmetricBlocks::Pair& pair : beyond) {
    full_.block<3, 3>(3 * pair.row, 3 * pair.column) += pair.below;
    full_.block<3, 3>(3 * pair.column, 3 * pair.row) += pair.above;
  }
  unsymmetric_.compute(full_);
}

void DenseSolver::solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) const {
  if (is_symmetric_) {
    x = b;
    symmetric_.solveInPlace(x);
  } else {
    x.noalias() = unsymmetric_.solve(b);
  }
}

}  // namespace talus
