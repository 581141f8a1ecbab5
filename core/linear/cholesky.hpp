#pragma once

#include <memory>

#include "base/state_archive.hpp"
#include "linear/not_positive_definite.hpp"
#include "linear/symmetric_blocks.hpp"

namespace talus {

/// Sparse Cholesky factorisation by CHOLMOD. The symbolic analysis is kept until the pattern changes.
class Cholesky {
 public:
  Cholesky();
  ~Cholesky();
  Cholesky(const Cholesky&) = delete;
  Cholesky& operator=(const Cholesky&) = delete;

  /// Orders and analyses.
  void analyse(const BlockPattern& pattern);
  /// Factors a matrix of the analysed pattern. Throws NotPositiveDefinite.
  void factor(const SymmetricBlocks& matrix);
  /// x = K⁻¹ b with the last factor.
  void solve(const Eigen::VectorXd& b, Eigen::VectorXd& x);
  double flops() const;    ///< of a factorisation of the analysed pattern
  double entries() const;  ///< of its factor

  /// The factor, with the pattern that was analysed: by the matrix that it is made of.
  void archive(StateArchive& state);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace talus
