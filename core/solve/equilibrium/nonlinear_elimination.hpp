#pragma once

#include <deque>
#include <span>
#include <utility>
#include <vector>

#include "base/disjoint_sets.hpp"
#include "linear/dense_solver.hpp"
#include "linear/sparse_part.hpp"
#include "solve/equilibrium/step_residual.hpp"

namespace talus {

/// Balances a few bodies by themselves, all others held where they are. A chip between boulders has contacts that open
/// and close as these move by a fraction of what is as good as nothing to them: it would set the pace of all. So, after
/// an iteration, bodies that are far out of balance while nearly all others are not are taken out and balanced first
/// (nonlinear elimination: Cai & Li 2011, "Inexact Newton methods with restricted additive Schwarz based nonlinear
/// elimination"). An iteration on them looks at their contacts alone and solves small systems. Where contacts of theirs
/// were changed, those that touch them are taken out with them. Among the bodies that are taken out a few may be left
/// far out of balance again: they are taken out from among these in the same way, and so on.
class NonlinearElimination {
 public:
  NonlinearElimination(const EliminationTolerances& tolerances, LinearSettings linear)
      : tolerances_(tolerances), linear_(linear) {}

  /// Which bodies are to be balanced alone, of those that are far out of balance.
  struct Choice {
    double most = 1;        ///< fraction of the bodies that are looked at; none are picked if there are more
    int contacts_away = 0;  ///< with those that touch them over so many contacts, while there are no more than that
    std::span<const double> worse_than{};  ///< N, a body: only those with a larger residual. Empty: all
  };
  /// Picks them at the gradient of the residual. If there are any, effects and the residual look at them alone from now
  /// on.
  bool begin(const Composition& composition, StepResidual& residual, const Choice& choice);
  /// They look again at those that they looked at before.
  void end(StepResidual& residual);
  /// How many times bodies were picked, each time from among those of the time before; 0: all are looked at.
  int depth() const { return depth_; }
  bool is_active() const { return depth_ > 0; }
  const PickedBodies& picked() const { return subsets_[depth_ - 1].picked; }

  /// x = T⁻¹ b of the bodies that were picked, zero elsewhere: exactly, or to the tolerance of the settings where many
  /// touch each other. Throws NotPositiveDefinite.
  void solve(const SymmetricBlocks& matrix, const UnsymmetricBlocks& unsymmetric, const Eigen::VectorXd& b,
             Eigen::VectorXd& x);
  const LinearWork& work() const { return work_; }

  /// What it has cost.
  void archive(auto& state) { state(work_); }

 private:
  struct Subset {
    PickedBodies picked;
    std::vector<int> grouped;              // degree-of-freedom blocks, system by system: they touch each other
    std::vector<std::size_t> system_ends;  // of each in grouped
  };
  bool pick_bodies(const Composition& composition, const StepResidual& residual, const Choice& choice,
                   PickedBodies& picked);
  /// Those that touch one that was picked, while there are no more than so many. False: there would be.
  bool pick_neighbours(const Composition& composition, std::size_t most, PickedBodies& picked);
  void split(const BlockPattern& pattern, Subset& subset);

  EliminationTolerances tolerances_;
  LinearSettings linear_;
  std::deque<Subset> subsets_;  // of the first `depth_` each is picked from the one before
  int depth_ = 0;
  std::vector<char> touches_picked_;            // a body
  std::vector<int> number_;                     // of a degree-of-freedom block: its place among those picked, or −1
  std::vector<std::pair<int, int>> by_system_;  // the first of its system, a degree-of-freedom block; sorted
  DisjointSets together_;
  DenseSolver dense_;
  SparsePart sparse_;
  LinearWork work_;
  Eigen::VectorXd right_, solution_;
};

}  // namespace talus
