#pragma once

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <span>
#include <vector>

#include "linear/symmetric_blocks.hpp"
#include "linear/unsymmetric_blocks.hpp"

namespace talus {

/// Solves small systems directly, their unsymmetric part included. Allocates where the size is not that of the last.
class DenseSolver {
 public:
  /// Unknowns up to which a new dense factor costs about as much as GMRES with an old sparse factor: 2 µs at 24, a
  /// third of a new sparse factor; at 36 it costs twice as much as GMRES.
  static constexpr int largest = 24;
  /// Of a part of a larger system: a dense factor of that size takes less than 1 ms, a sparse one of a system that is
  /// worth taking apart takes several.
  static constexpr int largest_part = 192;

  /// Factors the equations of some nodes, ascending; others that they are coupled to are held. Throws
  /// NotPositiveDefinite, with the node, if the symmetric matrix is not.
  void factor(const SymmetricBlocks& matrix, std::span<const UnsymmetricBlocks::Pair> unsymmetric,
              std::span<const int> nodes);
  /// x = T⁻¹ b with the last factor.
  void solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) const;

 private:
  std::vector<int> number_;  ///< of a node that was among the last ones: its number there
  Eigen::MatrixXd full_;
  /// Of something from the start: a solver that has not factored anything yet may be moved, and LLT then copies a state
  /// that only a factor sets.
  Eigen::LLT<Eigen::MatrixXd> cholesky_{Eigen::MatrixXd::Identity(1, 1)};
  Eigen::PartialPivLU<Eigen::MatrixXd> lu_;
  bool is_symmetric_ = true;
};

}  // namespace talus
