#pragma once

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <span>
#include <vector>

#include "effects/symmetric_blocks.hpp"
#include "effects/unsymmetric_blocks.hpp"

namespace talus {

/// Solves small systems directly, their unsymmetric part included. Allocates where the size is not that of the last.
class DenseSolver {
 public:
  /// Unknowns up to which a new dense factor costs about as much as GMRES with an old sparse one: 2 µs at 24, and a
  /// third of a new sparse one; at 36 twice as much as GMRES.
  static constexpr int largest = 24;

  /// Factors what couples some nodes, ascending, that couple with no others. Throws NotPositiveDefinite, with the node,
  /// if the symmetric part is not.
  void factor(const SymmetricBlocks& matrix, std::span<const UnsymmetricBlocks::Pair> beyond,
              std::span<const int> nodes);
  /// x = T⁻¹ b with the last factor.
  void solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) const;

 private:
  std::vector<int> number_;  ///< of a node that was among the last ones: its number there
  Eigen::MatrixXd full_;
  /// Of something from the start: a solver that has not factored anything yet may be moved, and LLT then copies a state
  /// that only a factor sets.
  Eigen::LLT<Eigen::MatrixXd> symmetric_{Eigen::MatrixXd::Identity(1, 1)};
  Eigen::PartialPivLU<Eigen::MatrixXd> unsymmetric_;
  bool is_symmetric_ = true;
};

}  // namespace talus
