#pragma once

#include <span>
#include <vector>

#include "effects/symmetric_blocks.hpp"
#include "effects/unsymmetric_blocks.hpp"

namespace talus {

/// Sparse LU factorisation by UMFPACK of a symmetric matrix with what is beyond it: for what is too far from symmetric
/// for GMRES with a factor of the symmetric part. Blocks that are zero take no part; the symbolic analysis is kept
/// until another block is not.
class SparseLu {
 public:
  SparseLu();
  ~SparseLu();
  SparseLu(const SparseLu&) = delete;
  SparseLu& operator=(const SparseLu&) = delete;

  /// Factors a matrix and what is beyond it on its pattern. Whether it is regular.
  bool factor(const SymmetricBlocks& matrix, std::span<const UnsymmetricBlocks::Pair> beyond);
  /// x = A⁻¹ b with the last factor; a matrix that is not regular has none.
  void solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) const;

 private:
  void forget_analysis();
  void forget_factor();
  /// Lays out the blocks that are present.
  void lay_out();
  /// Adds a 3×3 block at a block column; `place` is that of its first entry.
  void add(int place, int column, const Mat3& block);

  BlockPattern pattern_;
  std::vector<char> present_;                ///< of each slot of the pattern: its block is not zero, or was not
  std::vector<int> column_begin_{0}, rows_;  ///< all of the matrix, a number at a time, column by column
  std::vector<double> values_;
  std::vector<int> below_, above_;  ///< of each slot that is present: where its block begins, and where its transpose
  std::vector<int> heights_;        ///< of the columns of each node
  void* analysis_ = nullptr;
  void* factor_ = nullptr;
};

}  // namespace talus
