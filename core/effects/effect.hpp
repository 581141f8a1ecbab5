#pragma once

#include <limits>
#include <string_view>
#include <utility>
#include <vector>

#include "bodies/body_set.hpp"
#include "effects/symmetric_blocks.hpp"
#include "effects/time_integration.hpp"
#include "effects/unsymmetric_blocks.hpp"

namespace talus {

/// The step that is about to be tried.
struct StepContext {
  double time = 0;                ///< s, at the start of the step
  double length = 0;              ///< s, Δ
  double dynamic_factor = 1;      ///< share of the velocity that enters the step: 0 static, 1 dynamic
  TimeIntegration integration{};  ///< of this step; in static stages all forces are taken at its end
  double extent = 0;              ///< m, largest coordinate: where a step begins is rounded to 1e-16 of it
  double reach = std::numeric_limits<double>::infinity();  ///< m, beyond which no iteration leads at once
  double mesh_size = 0;  ///< m, largest of blocks that may move: a deformation gradient is rounded to 1e-16, an edge to
                         ///< this times it
};

/// The column of the energy ledger that an effect's energy belongs to.
enum class EnergyAccount { kinetic, elastic, potential, contact, damping, constraint };

/// One term Π_e(D) of the incremental potential whose minimum is the step, METHOD §1. Evaluations are const: a trial
/// step may be rejected, and history moves in `accept` alone.
class Effect {
 public:
  virtual ~Effect() = default;
  virtual std::string_view name() const = 0;
  virtual EnergyAccount account() const = 0;

  /// Does the Hessian stay the same for all D of a step? Such effects are assembled once a step.
  virtual bool quadratic() const { return true; }
  /// And in all steps of a stage that have one length? Such effects are assembled when that changes.
  virtual bool constant() const { return false; }
  /// Smooth forces are taken at the share of D that the time integration says, the others at its end.
  virtual bool smooth() const { return false; }
  /// Pairs of movable nodes that the Hessian may couple.
  virtual void add_couplings(std::vector<std::pair<int, int>>&) const {}
  /// The bodies stand at the start of the step; D is zero.
  virtual void begin_step(const StepContext&) {}
  virtual double energy(const Increment& d) const = 0;                            ///< J
  virtual void add_gradient(const Increment& d, Eigen::VectorXd& sum) const = 0;  ///< N
  /// Never negative: where the exact Hessian has a negative eigenvalue, its part is left out [N/m].
  virtual void add_hessian(const Increment&, SymmetricBlocks&) const {}
  /// What the derivative of the gradient has beyond the Hessian [N/m].
  virtual void add_unsymmetric(const Increment&, UnsymmetricBlocks&) const {}
  /// Of a smooth effect: the share of `change`, 0 to 1, by which D may go on and the energy stay a number.
  virtual double longest_share(const Increment&, const Increment& /*change*/) const { return 1; }
  /// The step is taken; the bodies' positions have not moved yet.
  virtual void accept(const Increment&) {}

  // For the ledger.
  virtual double stored_energy() const { return 0; }                 ///< J, of the present state
  virtual double dissipated(const Increment&) const { return 0; }    ///< J, in a step that is accepted
  virtual double work_on_held(const Increment&) const { return 0; }  ///< J, gradient·D over nodes without freedom

  /// Adds the effect's share of the present Cauchy stress, an element of the BodySet [Pa].
  virtual void add_stress(std::vector<Voigt>&) const {}
};

}  // namespace talus
