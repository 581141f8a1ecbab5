#pragma once

#include <span>
#include <vector>

#include "linear/symmetric_blocks.hpp"
#include "linear/unsymmetric_blocks.hpp"

namespace talus {

/// A tangent, a symmetric matrix plus an unsymmetric part, row by row and without blocks that are zero, for many
/// products on several cores.
class TangentRows {
 public:
  /// `unsymmetric`: of the pattern of the matrix, a pair of nodes once.
  void set(const SymmetricBlocks& matrix, std::span<const UnsymmetricBlocks::Pair> unsymmetric);
  /// y = T x.
  void multiply(const Eigen::VectorXd& x, Eigen::VectorXd& y) const;

 private:
  struct Block {
    int column;
    Mat3 value;
  };
  std::vector<int> pair_of_;  // of each slot of the pattern, −1: none
  std::vector<int> row_begin_;
  std::vector<Block> blocks_;
};

}  // namespace talus
