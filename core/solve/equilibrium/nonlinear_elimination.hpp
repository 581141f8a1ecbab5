#pragma once

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
/// were changed, those that touch them are taken out with them.
class NonlinearElimination {
 public:
  NonlinearElimination(const EliminationTolerances& tolerances, LinearSettings linear)
      : tolerances_(tolerances), linear_(linear) {}

  /// Picks the bodies that are to be balanced alone at the gradient of the residual, if they are no more than this
  /// fraction of all, and with them those that touch them over so many contacts, as long as that holds. If there are
  /// any, effects and the residual look at them alone from now on.
  bool begin(const Composition& composition, StepResidual& residual, double most, int contacts_away);
  /// They look at all bodies again.
  void end(StepResidual& residual);
  bool is_active() const { return !picked_.dof_blocks.empty(); }
  const PickedBodies& picked() const { return picked_; }

  /// x = T⁻¹ b of the bodies that were picked, zero elsewhere: exactly, or to the tolerance of the settings where many
  /// touch each other. Throws NotPositiveDefinite.
  void solve(const SymmetricBlocks& matrix, const UnsymmetricBlocks& unsymmetric, const Eigen::VectorXd& b,
             Eigen::VectorXd& x);
  const LinearWork& work() const { return work_; }

  /// What it has cost.
  void archive(auto& state) { state(work_); }

 private:
  bool pick_bodies(const BodySet& set, const ContactSet& contacts, const StepResidual& residual, double most,
                   int contacts_away);
  /// Those that touch one that was picked, while there are no more than so many. False: there would be.
  bool pick_neighbours(const BodySet& set, const ContactSet& contacts, std::size_t most);
  void split(const BlockPattern& pattern);

  EliminationTolerances tolerances_;
  LinearSettings linear_;
  PickedBodies picked_;
  std::vector<char> touches_picked_;            // a body
  std::vector<int> number_;                     // of a degree-of-freedom block: its place among those picked, or −1
  std::vector<std::pair<int, int>> by_system_;  // the first of its system, a degree-of-freedom block; sorted
  std::vector<int> grouped_;                    // degree-of-freedom blocks, system by system: they touch each other
  std::vector<std::size_t> system_ends_;        // of each in grouped_
  DisjointSets together_;
  DenseSolver dense_;
  SparsePart sparse_;
  LinearWork work_;
  Eigen::VectorXd right_, solution_;
};

}  // namespace talus
