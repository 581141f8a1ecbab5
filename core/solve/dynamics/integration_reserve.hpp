#pragma once

#include <span>
#include <vector>

#include "bodies/step_context.hpp"

namespace talus {

struct BodySet;

/// What Newmark's method holds of the energy of a motion, and gives back (Krenk 2006, Energy conservation in Newmark
/// based time integration algorithms). A step with forces that have a potential takes from the mechanical energy what
///   R = ½ (β − γ/2) Δ² aᵀ M a  [J]
/// grows by, or more, and gives back no more than it shrinks by: the sum of both never grows. So a body may begin a
/// step with the acceleration of the last one only as far as that has paid for it, and the ledger keeps account of what
/// was paid. A shorter step holds less of the same acceleration; what a longer one before it has paid beyond that is
/// kept for when steps are as long again. Steps of β = ½ (Body::constant_acceleration) hold nothing.
class IntegrationReserve {
 public:
  /// `set` outlives it.
  explicit IntegrationReserve(BodySet& set);

  /// Bodies have been given the accelerations with which they begin `step`, and what belongs to these in steps that are
  /// no longer than `longest` [s].
  void give(const StepContext& step, double longest);
  /// A step is about to be tried: where it is longer than the last one, bodies begin it with as much of their
  /// acceleration as is paid for. Where it is tried again, shorter, they have more of it.
  void begin_step(const StepContext& step);
  /// A step is about to be accepted: accelerations are those with which it begins.
  void note_start(const StepContext& step) { measure(step, at_start_); }
  /// It is accepted: accelerations are those with which the next one begins. Steps are no longer than `longest` [s].
  void hold(const StepContext& step, double longest);
  /// Impacts gave `energy` to these bodies [J], which time integration had taken from them in the step: they keep as
  /// much less, and of their accelerations what they have paid for.
  void release(std::span<const int> bodies, double energy);

  double total() const;  ///< J, all that is held

  /// What it remembers from step to step.
  void archive(auto& state) { state(held_, at_start_, at_end_, begun_with_, any_limited_, length_); }

 private:
  /// R of each body that moves, with its present acceleration [J].
  void measure(const StepContext& step, std::vector<double>& reserves) const;

  /// The next step follows on this one.
  void begin_from(const StepContext& step);

  BodySet& set_;
  std::vector<double> held_, at_start_, at_end_;  // J, a body
  std::vector<double> begun_with_;                // a body: of its acceleration, in the step that is tried
  bool any_limited_ = false;                      // some begin with less than all
  double length_ = 0;                             // s, of the last step
};

}  // namespace talus
