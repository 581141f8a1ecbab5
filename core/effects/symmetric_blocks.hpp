#pragma once

#include <utility>
#include <vector>

#include "base/vector.hpp"

namespace talus {

/// The symmetric matrix of the simultaneous equations, paper (1), as 3×3 blocks of movable nodes: the lower triangle,
/// column by column, on a pattern that is set once and refilled many times.
class SymmetricBlocks {
 public:
  /// `couplings`: pairs of movable nodes that some effect couples, in any order; the diagonal is always there.
  void set_pattern(int nodes, std::vector<std::pair<int, int>> couplings);

  /// Adds `block` at row i, column j, and its transpose at (j, i). The pair must be in the pattern.
  void add(int i, int j, const Mat3& block);

  /// What is added from now on counts this much.
  void set_weight(double weight) { weight_ = weight; }

  void set_zero();
  /// Takes over the values of a matrix with the same pattern.
  void assign(const SymmetricBlocks& other) { values_ = other.values_; }
  /// Norm of the diagonal.
  double diagonal_norm() const;
  /// y = K x.
  void multiply(const Eigen::VectorXd& x, Eigen::VectorXd& y) const;

  int nodes() const { return static_cast<int>(column_begin_.size()) - 1; }
  const std::vector<int>& column_begin() const { return column_begin_; }
  const std::vector<int>& rows() const { return rows_; }
  const Mat3& value(int slot) const { return values_[slot]; }

 private:
  std::vector<int> column_begin_{0};
  std::vector<int> rows_;  ///< ascending in each column, the diagonal first
  std::vector<Mat3> values_;
  double weight_ = 1;
};

}  // namespace talus
