#pragma once

#include <span>
#include <vector>

#include "linear/incomplete_solver.hpp"
#include "linear/linear_work.hpp"
#include "linear/tangent_factor.hpp"
#include "linear/unsymmetric_blocks.hpp"

namespace talus {

/// Some nodes of a matrix, too many for a dense factor. The pattern of their nonzero blocks is much sparser than that
/// of all contacts that may close. GMRES solves them with an incomplete factor where they are many; else, or where that
/// fails, with a Cholesky factor.
class SparsePart {
 public:
  /// Takes the equations of some nodes, ascending; others that they are coupled to are held.
  void take(const SymmetricBlocks& matrix, std::span<const UnsymmetricBlocks::Pair> unsymmetric,
            std::span<const int> nodes);
  /// Throws NotPositiveDefinite with the node of the matrix.
  void solve(const Eigen::VectorXd& b, const LinearSettings& settings, LinearWork& work, Eigen::VectorXd& x);

 private:
  void factor();

  SymmetricBlocks matrix_;
  std::vector<UnsymmetricBlocks::Pair> unsymmetric_;  ///< by node numbers in the part
  std::vector<int> nodes_;                            ///< of the part, by their numbers in the matrix
  std::vector<int> number_;                           ///< of a node that was among the last ones: its number there
  IncompleteSolver incomplete_;
  TangentFactor factor_;
  bool analysed_ = false;  ///< the factor, for the present pattern
};

}  // namespace talus
