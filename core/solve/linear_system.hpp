#pragma once

#include <vector>

#include "solve/independent_system.hpp"

namespace talus {

/// The linear equations of an iteration, T x = b, with T the symmetric matrix and what is beyond it. Blocks that do not
/// touch share no equation: each connected part of the pattern is a system of its own, is factored only when it has
/// changed, and solved only while it is out of balance.
class LinearSystem {
 public:
  explicit LinearSystem(LinearSettings settings) : settings_(settings) {}

  /// Finds the independent systems. Those whose nodes and couplings are as before keep their analysis and factor.
  void set_pattern(const BlockPattern& pattern);
  /// The matrix is about to change by more than old factors can serve for.
  void outdate();

  /// Solves for x; to the tolerance, or exactly where nothing is beyond the symmetric matrix and the factors are
  /// current. Systems whose right-hand sides are negligible, all together in norm, are left alone: x is zero there.
  /// Throws NotPositiveDefinite.
  void solve(const SymmetricBlocks& matrix, const UnsymmetricBlocks& beyond, const Eigen::VectorXd& b,
             double negligible, Eigen::VectorXd& x);
  const LinearWork& work() const { return work_; }

 private:
  LinearSettings settings_;
  std::vector<int> system_of_, number_in_system_;  ///< of each node
  std::vector<IndependentSystem> systems_;         ///< by their first nodes
  std::vector<double> sizes_;                      ///< norm of each system's right-hand side
  LinearWork work_;
};

}  // namespace talus
