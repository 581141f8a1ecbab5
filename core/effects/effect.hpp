#pragma once

#include <utility>
#include <vector>
#include "base/state_archive.hpp"

#include "bodies/body_set.hpp"
#include "bodies/picked_bodies.hpp"
#include "bodies/step_context.hpp"
#include "effects/effect_kind.hpp"
#include "linear/symmetric_blocks.hpp"
#include "linear/unsymmetric_blocks.hpp"

namespace talus {

/// The column of the energy ledger that an effect's energy belongs to.
enum class EnergyAccount { kinetic, elastic, potential, contact, damping, constraint };

/// One term Π_e(D) of the incremental potential whose minimum is the step (docs/theory.md). Evaluations are const: a
/// trial step may be rejected, and history moves in `accept` alone.
class Effect {
 public:
  virtual ~Effect() = default;
  virtual EffectKind kind() const = 0;
  virtual EnergyAccount account() const = 0;

  /// Does the Hessian stay the same for all D of a step? Such effects are assembled once a step.
  virtual bool quadratic() const { return true; }
  /// And in all steps of a stage that have one length? Such effects are assembled when that changes.
  virtual bool constant() const { return false; }
  /// Smooth forces are taken at the fraction of D that the time integration asks for, the others at all of D.
  virtual bool smooth() const { return false; }
  /// Pairs of movable nodes that the Hessian may couple.
  virtual void add_couplings(std::vector<std::pair<int, int>>&) const {}
  /// The bodies stand at the start of the step; D is zero.
  virtual void begin_step(const StepContext&) {}
  /// Until it is told null, what it adds is asked for of these bodies alone; it may leave out others or not.
  virtual void look_at(const PickedBodies*) {}
  virtual double energy(const Increment& d) const = 0;  ///< J
  /// Moments on rigid bodies are taken with these arms; a gradient of `energy` has those at the end of the step [N].
  virtual void add_gradient(const Increment& d, Arms arms, Eigen::VectorXd& sum) const = 0;
  /// Never negative: where the exact Hessian has a negative eigenvalue, its part is left out [N/m].
  virtual void add_hessian(const Increment&, SymmetricBlocks&) const {}
  /// The unsymmetric part of the tangent: the derivative of the gradient, less the Hessian [N/m].
  virtual void add_unsymmetric(const Increment&, Arms, UnsymmetricBlocks&) const {}
  /// Of a smooth effect: the largest fraction of `change`, 0 to 1, after which the energy is still finite.
  virtual double longest_step_fraction(const Increment&, const Increment& /*change*/) const { return 1; }
  /// The step is taken; the bodies' positions have not moved yet.
  virtual void accept(const Increment&) {}

  /// What it remembers from step to step, beside the bodies and their contacts.
  virtual void archive(StateArchive&) {}

  // For the ledger.
  virtual double stored_energy() const { return 0; }                 ///< J, of the present state
  virtual double dissipated(const Increment&) const { return 0; }    ///< J, in a step that is accepted
  virtual double work_on_held(const Increment&) const { return 0; }  ///< J, gradient·D over held nodes

  /// Adds the effect's part of the present Cauchy stress, an element of the BodySet [Pa].
  virtual void add_stress(std::vector<Voigt>&) const {}
};

}  // namespace talus
