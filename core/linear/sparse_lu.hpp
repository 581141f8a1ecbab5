#pragma once

#include <span>
#include <vector>

#include "base/state_archive.hpp"
#include "linear/symmetric_blocks.hpp"
#include "linear/unsymmetric_blocks.hpp"

namespace talus {

/// Sparse LU factorisation by UMFPACK of a symmetric matrix plus an unsymmetric part, where that part is too large for
/// GMRES with a factor of the symmetric matrix. Blocks that are zero are left out of the analysis, which is kept until
/// one of them becomes nonzero.
class SparseLu {
 public:
  SparseLu();
  ~SparseLu();
  SparseLu(const SparseLu&) = delete;
  SparseLu& operator=(const SparseLu&) = delete;

  /// Factors a matrix and its unsymmetric part on the same pattern. False: it has no factor, because it is singular or
  /// because UMFPACK could not analyse or factor it for want of memory.
  bool factor(const SymmetricBlocks& matrix, std::span<const UnsymmetricBlocks::Pair> unsymmetric);
  /// x = A⁻¹ b with the last factor, which there must be.
  void solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) const;

  /// What the next analysis hangs on.
  void archive(StateArchive& state);

 private:
  void forget_analysis();
  void forget_factor();
  /// Finds the symbolic factor of the matrix as laid out, where there is none yet. Whether there is one.
  bool analyse();
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
