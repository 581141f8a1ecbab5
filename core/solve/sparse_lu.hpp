#pragma once

#include <span>
#include <vector>

#include "effects/symmetric_blocks.hpp"
#include "effects/unsymmetric_blocks.hpp"

namespace talus {

/// Sparse LU factorisation by UMFPACK of a symmetric matrix with what is beyond it: for what is too far from symmetric
/// for GMRES with a factor of the symmetric part. The symbolic analysis is kept until the pattern changes.
class SparseLu {
 public:
  SparseLu();
  ~SparseLu();
  SparseLu(const SparseLu&) = delete;
  SparseLu& operator=(const SparseLu&) = delete;

  void set_pattern(const BlockPattern& pattern);
  /// Factors a matrix of this pattern; `beyond` lies in it, too. Whether it is regular.
  bool factor(const SymmetricBlocks& matrix, std::span<const UnsymmetricBlocks::Pair> beyond);
  /// x = A⁻¹ b with the last factor; a matrix that is not regular has none.
  void solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) const;

 private:
  void forget_analysis();
  void forget_factor();
  /// Adds a 3×3 block at a block row and column of which `place` is the place of the first entry.
  void add(int place, int column, const Mat3& block);

  int size_ = 0;
  std::vector<int> column_begin_, rows_;  ///< all of the matrix, a number at a time, column by column
  std::vector<double> values_;
  BlockPattern pattern_;
  std::vector<int> below_, above_;  ///< of each slot: where its block begins, and where its transpose does
  std::vector<int> heights_;        ///< of the columns of each node
  void* analysis_ = nullptr;
  void* factor_ = nullptr;
};

}  // namespace talus
