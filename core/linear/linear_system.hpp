#pragma once

#include <span>
#include <vector>

#include "linear/independent_system.hpp"

namespace talus {

/// The linear equations of an iteration, T x = b, where the tangent T is a symmetric matrix plus an unsymmetric part.
/// Blocks that do not touch share no equation: each connected part of the pattern is a system of its own, which is
/// factored only when it has changed and solved only while its residual is not negligible.
class LinearSystem {
 public:
  explicit LinearSystem(LinearSettings settings) : settings_(settings) {}

  /// Finds the independent systems. Those whose nodes and couplings are as before keep their analysis and factor.
  void set_pattern(const BlockPattern& pattern);
  /// The matrix is about to change so much that old factors are no good preconditioners any more.
  void outdate();
  /// The next solution is with whole factors of its own matrix.
  void demand_factors();

  /// Solves for x: to the tolerance of the settings, or exactly where there is no unsymmetric part and the factors are
  /// current. A system whose right-hand side is no larger in norm than what is `negligible` in it is not solved: x is
  /// zero there. One number a system, in the order of BlockPattern::connected_parts; none: 0. Throws
  /// NotPositiveDefinite.
  void solve(const SymmetricBlocks& matrix, const UnsymmetricBlocks& unsymmetric, const Eigen::VectorXd& b,
             std::span<const double> negligible, Eigen::VectorXd& x);
  const LinearWork& work() const { return work_; }

  const BlockPattern& pattern() const { return pattern_; }

  /// What it remembers from one solution to the next.
  void archive(auto& state) {
    BlockPattern pattern = pattern_;
    state(pattern);
    if (state.reads()) set_pattern(pattern);
    for (IndependentSystem& system : systems_) system.archive(state);
    state(trials_, work_);
  }

 private:
  /// Gives each system its pairs, in their order.
  void hand_out(std::span<const UnsymmetricBlocks::Pair> pairs);

  LinearSettings settings_;
  BlockPattern pattern_;
  std::vector<int> system_of_, number_in_system_;  ///< of each node
  std::vector<IndependentSystem> systems_;         ///< by their first nodes
  std::vector<int> places_, counts_;               ///< of each pair in its system; of each system: its pairs
  std::vector<double> sizes_;                      ///< norm of each system's right-hand side
  Trials trials_;                                  ///< of incomplete factors
  LinearWork work_;
};

}  // namespace talus
