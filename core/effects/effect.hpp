#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "bodies/body_set.hpp"
#include "effects/symmetric_blocks.hpp"

namespace talus {

/// The step that is about to be tried.
struct StepContext {
  double time = 0;            ///< s, at the start of the step
  double length = 0;          ///< s, Δ
  double dynamic_factor = 1;  ///< share of the velocity that enters the step: 0 static, 1 dynamic
};

/// One term Π_e(D) of the incremental potential whose minimum is the step, METHOD §1. Evaluations are const: a trial
/// step may be rejected, and history moves in `accept` alone.
class Effect {
 public:
  virtual ~Effect() = default;
  virtual std::string_view name() const = 0;

  /// Does the Hessian stay the same for all D of a step? Such effects are assembled once a step.
  virtual bool quadratic() const { return true; }
  /// Pairs of movable nodes that the Hessian may couple.
  virtual void add_couplings(std::vector<std::pair<int, int>>&) const {}
  /// The bodies stand at the start of the step; D is zero.
  virtual void begin_step(const StepContext&) {}
  virtual double energy(const Increment& d) const = 0;                            ///< J
  virtual void add_gradient(const Increment& d, Eigen::VectorXd& sum) const = 0;  ///< N
  virtual void add_hessian(const Increment&, SymmetricBlocks&) const {}           ///< N/m
  /// The step is taken; the bodies' positions have not moved yet.
  virtual void accept(const Increment&) {}
};

}  // namespace talus
