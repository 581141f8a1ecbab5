#pragma once

#include <vector>

#include "linear/symmetric_blocks.hpp"

namespace talus {

/// Incomplete factor L D Lᵀ of a positive definite matrix of 3×3 blocks, with the blocks of the matrix and no others
/// (Meijerink & van der Vorst 1977; Saad 2003, section 10.3): a preconditioner that costs as much as some products.
/// Where what was left out makes a block on the diagonal indefinite, the diagonal is enlarged (Manteuffel 1980).
class IncompleteCholesky {
 public:
  /// False: it is not positive definite with twice its diagonal either.
  bool factor(const SymmetricBlocks& matrix);
  void solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) const;

 private:
  bool factor(const SymmetricBlocks& matrix, double shift);

  BlockPattern pattern_;
  std::vector<Mat3> values_;   // of each slot: L below the diagonal
  std::vector<Mat3> inverse_;  // of the blocks of D
};

}  // namespace talus
