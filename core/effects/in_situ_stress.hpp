#pragma once

#include "effects/effect.hpp"

namespace talus {

/// Stress σ₀ that was in the rock before the run, borne along by the rock as it turns and strains:
///   Π = Σ_e V σ₀ : ½(FᵀF − I)  [J],   P = F σ₀
/// so that its force and its moment vanish with rotation as they must. For corotational strain; incremental strain
/// starts from it instead (initial stress, paper (10)(11)). The Hessian V g_aᵀσ₀g_b I counts only where σ₀ pulls.
class InSituStresses final : public Effect {
 public:
  explicit InSituStresses(const Project& project, const BlockSystem& system, const BodySet& set);
  EffectKind kind() const override { return EffectKind::initial_stress; }
  EnergyAccount account() const override { return EnergyAccount::elastic; }
  bool smooth() const override { return true; }
  void add_couplings(std::vector<std::pair<int, int>>& couplings) const override;
  void begin_step(const StepContext& step) override;
  double energy(const Increment& d) const override;
  void add_gradient(const Increment& d, Arms arms, Eigen::VectorXd& sum) const override;
  void add_hessian(const Increment& d, SymmetricBlocks& sum) const override;
  double stored_energy() const override;
  void add_stress(std::vector<Voigt>& stress) const override;

 private:
  const BodySet& set_;
  /// Of the increment, at which the deformation bears the stress along: ½ does the work of Π exactly.
  double end_fraction_ = 1;
  mutable Increment at_;                ///< m, there
  std::vector<Mat3> stress_, pulling_;  ///< Pa, by Element::number: σ₀ and its positive part
};

/// Stress before the run at the middle of every element of the set [Pa].
std::vector<Voigt> stress_before(const Project& project, const BlockSystem& system, const BodySet& set);

}  // namespace talus
