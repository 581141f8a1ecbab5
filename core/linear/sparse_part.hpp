#pragma once

#include <span>
#include <vector>

#include "linear/tangent_factor.hpp"
#include "linear/unsymmetric_blocks.hpp"

namespace talus {

/// Some nodes of a matrix, too many for a dense factor. The pattern of their nonzero blocks is much sparser than that
/// of all contacts that may close. Their Cholesky factor preconditions GMRES where they have an unsymmetric part.
class SparsePart {
 public:
  /// Factors the equations of some nodes, ascending; others that they are coupled to are held. Throws
  /// NotPositiveDefinite with the node of the matrix.
  void factor(const SymmetricBlocks& matrix, std::span<const UnsymmetricBlocks::Pair> unsymmetric,
              std::span<const int> nodes);
  /// Returns the number of GMRES iterations, 0 where the factor alone solves it.
  int solve(const Eigen::VectorXd& b, const LinearSettings& settings, Eigen::VectorXd& x);

 private:
  SymmetricBlocks matrix_;
  std::vector<UnsymmetricBlocks::Pair> unsymmetric_;  ///< by node numbers in the part
  std::vector<int> number_;                           ///< of a node that was among the last ones: its number there
  TangentFactor factor_;
};

}  // namespace talus
