#pragma once

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <span>

#include "effects/symmetric_blocks.hpp"
#include "effects/unsymmetric_blocks.hpp"

namespace talus {

/// Solves small systems directly, their unsymmetric part included. Allocates at the first of a size only.
class DenseSolver {
 public:
  /// Unknowns up to which a new dense factor costs about as much as GMRES with an old sparse one: 2 µs at 24, and a
  /// third of a new sparse one; at 36 twice as much as GMRES.
  static constexpr int largest = 24;

  /// Throws NotPositiveDefinite if the symmetric part is not.
  void factor(const SymmetricBlocks& matrix, std::span<const UnsymmetricBlocks::Pair> beyond);
  /// x = T⁻¹ b with the last factor.
  void solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) const;

 private:
  Eigen::MatrixXd full_;
  Eigen::LLT<Eigen::MatrixXd> symmetric_;
  Eigen::PartialPivLU<Eigen::MatrixXd> unsymmetric_;
  bool is_symmetric_ = true;
};

}  // namespace talus
