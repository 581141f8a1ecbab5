#pragma once

#include "effects/effect.hpp"

namespace talus {

/// Strain energy of the strain of this step, paper (8)(9):
///   Π = ½ Σ_e ∫ εᵀ E ε dv,  ε = B_e D_e  [J]
/// on the shape at the start of the step. `accept` adds the new stress to the bodies'.
class Elasticity final : public Effect {
 public:
  explicit Elasticity(BodySet& set) : set_(set) {}
  EffectKind kind() const override { return EffectKind::elasticity; }
  EnergyAccount account() const override { return EnergyAccount::elastic; }
  bool smooth() const override { return true; }
  void add_couplings(std::vector<std::pair<int, int>>& couplings) const override;
  double energy(const Increment& d) const override;
  void add_gradient(const Increment& d, Arms arms, Eigen::VectorXd& sum) const override;
  void add_hessian(const Increment& d, SymmetricBlocks& sum) const override;
  void accept(const Increment& d) override;
  double stored_energy() const override;
  void add_stress(std::vector<Voigt>& stress) const override;

 private:
  Voigt new_stress(std::size_t element, const Increment& d) const;
  BodySet& set_;
};

}  // namespace talus
