#pragma once

#include "model/solver_settings.hpp"

namespace talus {

/// Weights of a time integration of the generalised-α family (Chung & Hulbert 1993). Newmark's methods are those with
/// α_m = α_f = 0. A step of length Δ takes positions x₀, velocities v₀ and accelerations a₀ to x₀ + D, v₁ and a₁:
///   M [(1 − α_m) a₁ + α_m a₀] + F_smooth(x₀ + (1 − α_f) D) + F_contact(x₀ + D) = 0
///   D = Δ v₀ + Δ² [(½ − β) a₀ + β a₁],   v₁ = v₀ + Δ [(1 − γ) a₀ + γ a₁].
/// Forces of contacts and held points, which are stiff and come and go, are always taken at the end of the step.
struct TimeIntegration {
  double beta = 9.0 / 16, gamma = 1, alpha_m = 0, alpha_f = 0;

  /// The paper's, (12)–(21). Exact where the acceleration is constant. The velocity of a sticking node changes its sign
  /// each step: the eigenvalue is −1 at infinite stiffness.
  static TimeIntegration constant_acceleration() { return {0.5, 1, 0, 0}; }
  /// Newmark's with γ = 1 and β = (γ + ½)²/4. Infinitely stiff modes are multiplied by −1/3 each step.
  static TimeIntegration newmark() { return {9.0 / 16, 1, 0, 0}; }
  /// Second order. Infinitely fast modes shrink to `spectral_radius` (0 … 1) of their size each step; with 1 the energy
  /// of linear systems is conserved.
  static TimeIntegration generalized_alpha(double spectral_radius);
  /// The one that the settings ask for.
  static TimeIntegration of(const SolverSettings& settings);

  /// Whether the weight of a₀ in D takes the forces of blows over into the next step (AccelerationReset). It does in
  /// Newmark's methods with β ≠ ½; generalised-α's weights come with an α_m that makes up for it.
  bool carries_acceleration() const { return beta != 0.5 && alpha_m == 0; }
  /// Fraction of the increment at which smooth forces are taken.
  double smooth_fraction() const { return 1 - alpha_f; }
  bool operator==(const TimeIntegration&) const = default;

  void archive(auto& state) { state(beta, gamma, alpha_m, alpha_f); }
};

}  // namespace talus
