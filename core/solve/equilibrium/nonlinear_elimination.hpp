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
  /// any, contact effects and the residual look at them alone from now on.
  bool begin(const Composition& composition, StepResidual& residual, double most, int contacts_away);
  /// They look at all bodies again.
  void end(const Composition& composition, StepResidual& residual);
  bool is_active() const { return !dof_blocks_.empty(); }
  const std::vector<int>& dof_blocks() const { return dof_blocks_; }  ///< of the bodies that were picked, ascending

  /// x = T⁻¹ b of the bodies that were picked, zero elsewhere: exactly, or to the tolerance of the settings where many
  /// touch each other. Throws NotPositiveDefinite.
  void solve(const SymmetricBlocks& matrix, const UnsymmetricBlocks& unsymmetric, const Eigen::VectorXd& b,
             Eigen::VectorXd& x);

 private:
  bool pick_bodies(const BodySet& set, const ContactSet& contacts, const StepResidual& residual, double most,
                   int contacts_away);
  /// Those that touch one that was picked, while there are no more than so many. False: there would be.
  bool pick_neighbours(const BodySet& set, const ContactSet& contacts, std::size_t most);
  void pick_points(const Composition& composition);
  void split(const BlockPattern& pattern);

  EliminationTolerances tolerances_;
  LinearSettings linear_;
  std::vector<int> bodies_, dof_blocks_;
  std::vector<char> is_picked_, touches_picked_;  // a body
  std::vector<std::vector<int>> points_;          // of each normal contact, and of shear contact
  std::vector<int> number_;                       // of a degree-of-freedom block: its place in dof_blocks_, or −1
  std::vector<std::pair<int, int>> by_system_;    // the first of its system, a degree-of-freedom block; sorted
  std::vector<int> grouped_;                      // degree-of-freedom blocks, system by system: they touch each other
  std::vector<std::size_t> system_ends_;          // of each in grouped_
  DisjointSets together_;
  DenseSolver dense_;
  SparsePart sparse_;
  Eigen::VectorXd right_, solution_;
};

}  // namespace talus
