#pragma once

#include <span>
#include <vector>

#include "base/vector.hpp"
#include "linear/block_pattern.hpp"

namespace talus {

/// The unsymmetric part of the tangent, to be added to the symmetric matrix: 3×3 blocks on the same pattern, both
/// triangles stored. Only pairs that something was added to are stored, cleared and multiplied, so that it costs
/// nothing where no effect adds anything.
class UnsymmetricBlocks {
 public:
  /// The blocks of a pair of nodes; on the diagonal all of it is `below`.
  struct Pair {
    int row, column;    ///< row ≥ column
    Mat3 below, above;  ///< at (row, column) and at (column, row)
  };

  void set_pattern(const BlockPattern& pattern);
  void set_zero();
  /// Adds `block` at row i, column j, in any order. The pair must be in the pattern.
  void add(int i, int j, const Mat3& block) { add_at(pattern_.slot(i, j), i, j, block); }
  /// The same where the slot of the pair is known.
  void add_at(int slot, int i, int j, const Mat3& block);
  /// Stores the pair before anything is added: then several threads may add to pairs of their own.
  void make_room(int slot, int i, int j);
  const BlockPattern& pattern() const { return pattern_; }

  /// In the order in which they were first added to.
  std::span<const Pair> pairs() const { return std::span(pairs_).first(slots_.size()); }

  /// y += U x, with U of these pairs.
  static void add_product(std::span<const Pair> pairs, const Eigen::VectorXd& x, Eigen::VectorXd& y);

 private:
  BlockPattern pattern_;
  std::vector<int> pair_;    ///< of each slot of the pattern, −1: none
  std::vector<int> slots_;   ///< of each pair
  std::vector<Pair> pairs_;  ///< and zero ones behind them, that are used next
};

}  // namespace talus
