#pragma once

#include <span>
#include <vector>

#include "effects/unsymmetric_blocks.hpp"
#include "solve/tangent_factor.hpp"

namespace talus {

/// A part of a matrix that is too large for a dense factor: what is not zero in it has a pattern of its own, much
/// sparser than that of all contacts that may close. Its Cholesky factor preconditions GMRES on the part with what is
/// beyond the symmetric matrix.
class SparsePart {
 public:
  /// `nodes`: ascending, coupled to no others. Throws NotPositiveDefinite with the node of the matrix.
  void factor(const SymmetricBlocks& matrix, std::span<const UnsymmetricBlocks::Pair> beyond,
              std::span<const int> nodes);
  /// Returns the iterations that took, 0 where the factor alone solves it.
  int solve(const Eigen::VectorXd& b, const LinearSettings& settings, Eigen::VectorXd& x);

 private:
  SymmetricBlocks matrix_;
  std::vector<UnsymmetricBlocks::Pair> beyond_;  ///< by numbers in the part
  std::vector<int> number_;                      ///< in the part, of those of its nodes; of others anything
  std::vector<std::pair<int, int>> couplings_;
  TangentFactor factor_;
};

}  // namespace talus
