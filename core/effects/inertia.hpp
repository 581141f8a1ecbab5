#pragma once

#include "effects/effect.hpp"

namespace talus {

/// Inertia with constant acceleration over the step, paper (12)–(21):
///   Π = 1/Δ² (D − Δ V₀)ᵀ M (D − Δ V₀)  [J],  M = ∫ ρ NᵀN dv
/// whose gradient M(2/Δ² D − 2/Δ V₀) is the paper's (18). V₀ is the velocity at the start of the step times the stage's
/// dynamic factor. This is Newmark's method with β = ½, γ = 1. `accept` moves the velocity by (21); in a static stage
/// to zero.
class Inertia final : public Effect {
 public:
  explicit Inertia(BodySet& set) : set_(set) {}
  std::string_view name() const override { return "inertia"; }
  void begin_step(const StepContext& step) override;
  double energy(const Increment& d) const override;
  void add_gradient(const Increment& d, Eigen::VectorXd& sum) const override;
  void add_hessian(const Increment& d, SymmetricBlocks& sum) const override;
  void accept(const Increment& d) override;

  /// ½ VᵀMV of the bodies' present velocities [J].
  static double kinetic_energy(const BodySet& set);

 private:
  /// D − Δ V₀ at the element's corners [m].
  Corners departure(const Element& element, const Increment& d) const;
  BodySet& set_;
  StepContext step_;
};

}  // namespace talus
