#pragma once

#include <span>

#include "linear/cholesky.hpp"
#include "linear/gmres.hpp"
#include "linear/unsymmetric_blocks.hpp"

namespace talus {

/// Where GMRES stops.
struct LinearSettings {
  double tolerance;          ///< residual over right-hand side of a system
  int limit;                 ///< iterations after which the matrix is factored again
  int incomplete_limit = 0;  ///< iterations with an incomplete factor after which a system gets one
};

/// Cholesky factor of the symmetric part of a tangent. It preconditions GMRES on the whole tangent, and on later ones
/// as long as that converges fast enough.
class TangentFactor {
 public:
  void analyse(const BlockPattern& pattern) { cholesky_.analyse(pattern); }
  /// Throws NotPositiveDefinite with the node.
  void factor(const SymmetricBlocks& matrix) { cholesky_.factor(matrix); }
  const Cholesky& cholesky() const { return cholesky_; }

  /// Solves with the matrix that was factored, without an unsymmetric part.
  void solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) { cholesky_.solve(b, x); }
  /// Solves with a matrix like it plus an unsymmetric part. Returns the number of iterations; the limit if the
  /// tolerance was not reached.
  int solve(const SymmetricBlocks& matrix, std::span<const UnsymmetricBlocks::Pair> unsymmetric,
            const Eigen::VectorXd& b, const LinearSettings& settings, Eigen::VectorXd& x);

  /// The factor, with the pattern that was analysed.
  void archive(StateArchive& state) { cholesky_.archive(state); }

 private:
  Cholesky cholesky_;
  Gmres gmres_;
};

}  // namespace talus
