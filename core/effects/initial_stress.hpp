#pragma once

#include "effects/effect.hpp"

namespace talus {

/// Work of the stress σ₀ that the earlier steps left in the blocks, paper (10)(11):
///   Π = Σ_e ∫ εᵀ σ₀ dv  [J]
class InitialStress final : public Effect {
 public:
  explicit InitialStress(const BodySet& set) : set_(set) {}
  EffectKind kind() const override { return EffectKind::initial_stress; }
  EnergyAccount account() const override { return EnergyAccount::elastic; }
  bool smooth() const override { return true; }
  double energy(const Increment& d) const override;
  void add_gradient(const Increment& d, Arms arms, Eigen::VectorXd& sum) const override;

 private:
  const BodySet& set_;
};

}  // namespace talus
