#pragma once

#include <span>
#include <utility>
#include <vector>

#include "base/vector.hpp"
#include "linear/block_pattern.hpp"

namespace talus {

/// The symmetric matrix of the simultaneous equations, paper (1), as 3×3 blocks of movable nodes: the lower triangle,
/// column by column, on a pattern that is set once and refilled many times.
class SymmetricBlocks {
 public:
  /// `couplings`: pairs of movable nodes that some effect couples, in any order; the diagonal is always there.
  void set_pattern(int nodes, std::vector<std::pair<int, int>> couplings) {
    set_pattern(BlockPattern(nodes, std::move(couplings)));
  }
  void set_pattern(BlockPattern pattern);

  /// Adds `block` at row i, column j, and its transpose at (j, i). The pair must be in the pattern.
  void add(int i, int j, const Mat3& block) { add_at(pattern_.slot(i, j), i, j, block); }
  /// The same where the slot of the pair is known: finding it takes longer than adding.
  void add_at(int slot, int i, int j, const Mat3& block) {
    if (i >= j)
      values_[slot] += weight_ * block;
    else
      values_[slot] += weight_ * block.transpose();
  }
  /// Adds `block` at the row and column of a slot of the pattern, its transpose at (column, row).
  void add_at(int slot, const Mat3& block) { values_[slot] += weight_ * block; }

  /// What is added from now on counts this much.
  void set_weight(double weight) { weight_ = weight; }

  void set_zero();
  /// Takes over the values of a matrix with the same pattern: all, and those of some columns of the lower triangle.
  void assign(const SymmetricBlocks& other) { values_ = other.values_; }
  void assign_columns(const SymmetricBlocks& other, std::span<const int> columns);
  /// Takes over the columns of some nodes of a larger matrix, of which this pattern is their part. Has a bit changed?
  bool assign_part(const SymmetricBlocks& whole, std::span<const int> nodes);
  /// Norm of the diagonal, and of its part from block `begin` to that before `end`.
  double diagonal_norm() const;
  double diagonal_norm(int begin, int end) const;
  /// y = K x.
  void multiply(const Eigen::VectorXd& x, Eigen::VectorXd& y) const;

  int nodes() const { return pattern_.nodes(); }
  const BlockPattern& pattern() const { return pattern_; }
  const Mat3& value(int slot) const { return values_[slot]; }

  /// Its values, with the pattern that it has.
  void archive(auto& state) { state(values_); }

 private:
  BlockPattern pattern_;
  std::vector<Mat3> values_;  ///< of each slot
  double weight_ = 1;
};

}  // namespace talus
