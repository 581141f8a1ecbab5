#pragma once

#include <span>

#include "effects/unsymmetric_blocks.hpp"
#include "solve/cholesky.hpp"
#include "solve/gmres.hpp"

namespace talus {

/// How far GMRES goes.
struct LinearSettings {
  double tolerance = 1e-4;  ///< of the right-hand side of a system
  int limit = 40;           ///< iterations after which the matrix is factored anew
};

/// Cholesky factor of the symmetric part of a tangent. It preconditions GMRES on all of that tangent, and on later ones
/// as long as it serves.
class TangentFactor {
 public:
  void analyse(const BlockPattern& pattern) { cholesky_.analyse(pattern); }
  /// Throws NotPositiveDefinite with the node.
  void factor(const SymmetricBlocks& matrix) { cholesky_.factor(matrix); }
  const Cholesky& cholesky() const { return cholesky_; }

  /// What was factored, nothing beyond it, times x = b.
  void solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) { cholesky_.solve(b, x); }
  /// A matrix like it and what is beyond, together times x = b. Returns the iterations that took, the limit in vain.
  int solve(const SymmetricBlocks& matrix, std::span<const UnsymmetricBlocks::Pair> beyond, const Eigen::VectorXd& b,
            const LinearSettings& settings, Eigen::VectorXd& x);

 private:
  Cholesky cholesky_;
  Gmres gmres_;
};

}  // namespace talus
