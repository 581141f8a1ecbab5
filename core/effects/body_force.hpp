#pragma once

#include "effects/effect.hpp"

namespace talus {

/// Work of gravity, a constant body force f = ρ g, paper (27)(28):
///   Π = −∫ uᵀ f dv  [J]
class BodyForce final : public Effect {
 public:
  /// `gravity` [m/s²].
  BodyForce(const BodySet& set, const Vec3& gravity) : set_(set), gravity_(gravity) {}
  EffectKind kind() const override { return EffectKind::body_force; }
  EnergyAccount account() const override { return EnergyAccount::potential; }
  void look_at(const PickedBodies* picked) override { picked_ = picked; }
  double energy(const Increment& d) const override;
  void add_gradient(const Increment& d, Arms arms, Eigen::VectorXd& sum) const override;
  double stored_energy() const override;  ///< above the reference positions

 private:
  const BodySet& set_;
  Vec3 gravity_;
  const PickedBodies* picked_ = nullptr;
};

}  // namespace talus
