#pragma once

#include "model/solver_tolerances.hpp"

namespace talus {

/// Pseudo-transient continuation of static stages: which fraction of inertia a static step keeps. There inertia only
/// keeps loose blocks from running away: in a step a residual force F moves a mass m by F βΔ²/m. Where many blocks lean
/// on each other equilibrium comes slowly that way, by some per cent a step. So inertia fades with the residual to the
/// power of 3/2 (switched evolution relaxation: Mulder & van Leer 1985; the power: Gropp, Kaushik, Keyes & Smith 2001),
/// while steps lead no farther than twice as far as those with full inertia. What slides or falls keeps its residual
/// and so its inertia: it creeps by F βΔ²/m a step.
class PseudoTransientContinuation {
 public:
  explicit PseudoTransientContinuation(const PseudoTransientTolerances& tolerances = {}) : tolerances_(tolerances) {}

  /// Full inertia, until steps say otherwise.
  void begin_stage() { *this = PseudoTransientContinuation(tolerances_); }
  /// Of the mass, in (0, 1]; a power of two, so that it does not change by little.
  double inertia_fraction() const { return fraction_; }
  /// Whether a step with less than full inertia did not converge, or moved a node too far [m]: then it is to be taken
  /// anew with more.
  bool needs_retry(bool converged, double displacement) const;
  /// Raises the fraction after such a step.
  void restore_inertia(bool converged, double displacement);
  /// A step is accepted that moved no node farther than `displacement` [m] and left `static_residual`
  /// (StepResidual::static_residual).
  void accept(double displacement, double static_residual);

  /// What it remembers from step to step.
  void archive(auto& state) { state(fraction_, wanted_, last_static_residual_, longest_displacement_); }

 private:
  /// With which a step like this one would have led just as far as it may.
  double fraction_for(double displacement) const;
  /// The next power of two that is not less, in range.
  double power_of_two(double fraction) const;

  PseudoTransientTolerances tolerances_;
  double fraction_ = 1;
  double wanted_ = 1;  ///< by the residual alone, in (0, 1]
  double last_static_residual_ = 0;
  double longest_displacement_ = 0;  ///< m, of a node in a step with full inertia
};

}  // namespace talus
