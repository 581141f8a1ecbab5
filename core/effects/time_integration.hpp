#pragma once

#include "model/solver_settings.hpp"

namespace talus {

/// Weights of the generalised-α family (Chung & Hulbert 1993), which holds Newmark's methods:
///   M [(1 − α_m) a₁ + α_m a₀] + F_smooth(x₀ + (1 − α_f) D) + F_contact(x₀ + D) = 0
///   D = Δ v₀ + Δ² [(½ − β) a₀ + β a₁],   v₁ = v₀ + Δ [(1 − γ) a₀ + γ a₁].
/// Contacts and held points are always taken at the end of the step: they are stiff and open and close.
struct TimeIntegration {
  double beta = 9.0 / 16, gamma = 1, alpha_m = 0, alpha_f = 0;

  /// The paper's, (12)–(21): exact for constant acceleration; turns the velocity of a sticking node round each step
  /// (eigenvalue −1 at infinite stiffness).
  static TimeIntegration constant_acceleration() { return {0.5, 1, 0, 0}; }
  /// β = (γ + ½)²/4, which damps infinitely stiff modes by −1/3 a step.
  static TimeIntegration newmark() { return {9.0 / 16, 1, 0, 0}; }
  /// Second order; infinitely fast modes shrink to `spectral_radius` a step, 1 conserves what is linear.
  static TimeIntegration generalized_alpha(double spectral_radius);
  static TimeIntegration of(const SolverSettings& settings);

  /// Whether a step holds on to the acceleration of the last one by weights that do not come from Hamilton's principle.
  bool holds_on_to_blows() const { return beta != 0.5 && alpha_m == 0; }
  /// Share of the increment at which smooth forces are taken.
  double smooth_share() const { return 1 - alpha_f; }
  bool operator==(const TimeIntegration&) const = default;
};

}  // namespace talus
