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
  /// Up to so many unknowns it takes less time than the sparse one: a rigid or affine block, two of them, a cube of
  /// tetrahedra.
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
