#pragma once

#include "effects/effect.hpp"

namespace talus {

/// Viscous damping of the mass at rate c [1/s], a body force density −c ρ v with the mean velocity of the step:
///   Π = c/(2Δ) Dᵀ M D  [J]
/// and of a rigid body c times its momentum and its angular momentum halfway. It dissipates c/Δ DᵀMD a step. Relative
/// to the ground at rest, in static stages too.
class Damping final : public Effect {
 public:
  /// `rates`: one a body [1/s].
  Damping(const BodySet& set, std::vector<double> rates) : set_(set), rates_(std::move(rates)) {}
  EffectKind kind() const override { return EffectKind::damping; }
  EnergyAccount account() const override { return EnergyAccount::damping; }
  bool constant() const override { return set_.turning.empty(); }
  void begin_step(const StepContext& step) override { length_ = step.length; }
  void look_at(const PickedBodies* picked) override { picked_ = picked; }
  double energy(const Increment& d) const override;
  void add_gradient(const Increment& d, Arms arms, Eigen::VectorXd& sum) const override;
  void add_hessian(const Increment& d, SymmetricBlocks& sum) const override;
  void add_unsymmetric(const Increment& d, Arms arms, UnsymmetricBlocks& sum) const override;
  double dissipated(const Increment& d) const override { return 2 * energy(d); }

 private:
  double rate_of(const Element& element) const;  ///< N/m, of the twentieth that the consistent mass is made of
  double rate_of(const RigidBody& body) const;   ///< 1/s², of mass and inertia
  const BodySet& set_;
  std::vector<double> rates_;
  double length_ = 1;
  const PickedBodies* picked_ = nullptr;
};

}  // namespace talus
