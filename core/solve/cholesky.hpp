#pragma once

#include <memory>
#include <stdexcept>

#include "effects/symmetric_blocks.hpp"

namespace talus {

/// The matrix has a direction without stiffness or mass: our own mistake, or numbers beyond reason in the input.
struct NotPositiveDefinite : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Sparse Cholesky factorisation by CHOLMOD. The symbolic analysis is kept until the pattern changes.
class Cholesky {
 public:
  Cholesky();
  ~Cholesky();
  Cholesky(const Cholesky&) = delete;
  Cholesky& operator=(const Cholesky&) = delete;

  /// Orders and analyses the pattern of `matrix`; its values do not matter.
  void analyse(const SymmetricBlocks& matrix);
  /// Factors a matrix of the analysed pattern. Throws NotPositiveDefinite.
  void factor(const SymmetricBlocks& matrix);
  /// x = K⁻¹ b with the last factor.
  void solve(const Eigen::VectorXd& b, Eigen::VectorXd& x);
  double flops() const;    ///< of a factorisation of the analysed pattern
  double entries() const;  ///< of its factor

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace talus
