#pragma once

#include "linear/incomplete_cholesky.hpp"
#include "linear/linear_work.hpp"
#include "linear/tangent_factor.hpp"
#include "linear/tangent_rows.hpp"

namespace talus {

/// GMRES on a tangent with an incomplete factor of its symmetric part.
class IncompleteSolver {
 public:
  /// A system of fewer blocks gets a whole factor: it fills in little, and leaves exacter last digits.
  static constexpr int many_blocks = 500;

  /// False: the system is small, or not solved within the settings' `incomplete_limit`.
  bool solve(const SymmetricBlocks& matrix, std::span<const UnsymmetricBlocks::Pair> unsymmetric,
             const Eigen::VectorXd& b, const LinearSettings& settings, LinearWork& work, Eigen::VectorXd& x);

 private:
  /// Factor and rows, both at once; false: there is no factor.
  bool prepare(const SymmetricBlocks& matrix, std::span<const UnsymmetricBlocks::Pair> unsymmetric);

  TangentRows rows_;
  IncompleteCholesky incomplete_;
  Gmres gmres_;
};

}  // namespace talus
