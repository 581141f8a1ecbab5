#pragma once

#include <span>

#include "effects/effect.hpp"

namespace talus {

/// Inertia, paper (12)–(21), for any integrator of TimeIntegration's family:
///   Π = (1 − α_m) βΔ²/2 a₁ᵀ M a₁ + α_m a₀ᵀ M D  [J],  M = ∫ ρ NᵀN dv
///   a₁ = (D − Δ V₀ − (½ − β) Δ² a₀) / (βΔ²)
/// whose gradient is M[(1 − α_m) a₁ + α_m a₀]; with β = ½, α_m = 0 it is the paper's (18), M(2/Δ² D − 2/Δ V₀). V₀ and
/// a₀ are taken times the stage's dynamic factor. `accept` moves velocity and acceleration; in a static stage to zero.
/// Rigid bodies: effects/rigid_inertia; their turning has no potential, and `energy` is without them.
class Inertia final : public Effect {
 public:
  explicit Inertia(BodySet& set) : set_(set) {}
  EffectKind kind() const override { return EffectKind::inertia; }
  EnergyAccount account() const override { return EnergyAccount::kinetic; }
  bool constant() const override { return set_.turning.empty(); }
  void begin_step(const StepContext& step) override { step_ = step; }
  void look_at(const PickedBodies* picked) override { picked_ = picked; }
  void add_couplings(std::vector<std::pair<int, int>>& couplings) const override;
  double energy(const Increment& d) const override;
  void add_gradient(const Increment& d, Arms arms, Eigen::VectorXd& sum) const override;
  void add_hessian(const Increment& d, SymmetricBlocks& sum) const override;
  void add_unsymmetric(const Increment& d, Arms arms, UnsymmetricBlocks& sum) const override;
  void accept(const Increment& d) override;
  double stored_energy() const override { return kinetic_energy(set_); }

  /// Estimated error of the displacement that time integration makes in this step [m], the largest of all nodes:
  /// |β − 1/6| Δ² |a₁ − a₀| (Zienkiewicz & Xie 1991).
  double time_error(const Increment& d) const;

  /// ½ VᵀMV of the present velocities [J], of all bodies and of some.
  static double kinetic_energy(const BodySet& set);
  static double kinetic_energy(const BodySet& set, std::span<const int> bodies);

 private:
  BodySet& set_;
  StepContext step_;
  const PickedBodies* picked_ = nullptr;
};

}  // namespace talus
