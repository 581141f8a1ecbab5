#pragma once

#include <span>
#include <vector>

#include "linear/coupled_parts.hpp"
#include "linear/tangent_factor.hpp"
#include "linear/unsymmetric_blocks.hpp"

namespace talus {

/// A connected part of a matrix that is too large for a dense factor. The pattern of its nonzero blocks is much sparser
/// than that of all contacts that may close. Its Cholesky factor preconditions GMRES where it has an unsymmetric part.
class SparsePart {
 public:
  /// This part of the parts of a matrix. Throws NotPositiveDefinite with the node of the matrix.
  void factor(const SymmetricBlocks& matrix, std::span<const UnsymmetricBlocks::Pair> unsymmetric,
              const CoupledParts& parts, int part);
  /// Returns the number of GMRES iterations, 0 where the factor alone solves it.
  int solve(const Eigen::VectorXd& b, const LinearSettings& settings, Eigen::VectorXd& x);

 private:
  SymmetricBlocks matrix_;
  std::vector<UnsymmetricBlocks::Pair> unsymmetric_;  ///< by node numbers in the part
  std::vector<int> number_;                           ///< in the part, of those of its nodes; of others anything
  TangentFactor factor_;
};

}  // namespace talus
