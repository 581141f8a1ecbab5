#pragma once

#include "bodies/element_sums.hpp"
#include "effects/effect.hpp"
#include "model/solver_tolerances.hpp"

namespace talus {

/// Strain energy of rock that no stress squeezes to nothing (Simo & Pister 1984). With the deformation gradient F of an
/// element, C = FᵀF and J = det F:
///   Π = Σ_e V [μ/2 (tr C − 3) − μ ln J + λ/2 (ln J)²]  [J],   P = ∂Π/∂F = F S,   S = μ (I − C⁻¹) + λ ln J C⁻¹
/// Small strains are those of linear rock with the same λ and μ; where J falls to 0 the energy is infinite.
/// In dynamic steps whose forces are taken at the end, P = ½(F₀ + F₁) S₁, whose work over the step is ½ S₁:(C₁ − C₀).
/// That is never less than what Π gains while Π is convex in C, which is where J ≤ exp(μ/λ); and S is symmetric, so
/// that angular momentum is kept. (Compare Simo & Tarnow 1992, who take S such that no energy goes at all.) The Hessian
/// is that of P = F S with what pulls of S, and without the rest, which may be negative; the rest of the tangent of
/// ½(F₀ + F₁) S₁ is the unsymmetric part.
class NeoHookeanElasticity final : public Effect {
 public:
  explicit NeoHookeanElasticity(const BodySet& set, const EffectTolerances& tolerances = {})
      : set_(set), tolerances_(tolerances), sums_(set) {}
  EffectKind kind() const override { return EffectKind::neo_hookean_elasticity; }
  EnergyAccount account() const override { return EnergyAccount::elastic; }
  bool quadratic() const override { return false; }
  bool smooth() const override { return true; }
  void begin_step(const StepContext& step) override;
  void add_couplings(std::vector<std::pair<int, int>>& couplings) const override;
  /// Infinite where an element is turned inside out.
  double energy(const Increment& d) const override;
  void add_gradient(const Increment& d, Arms arms, Eigen::VectorXd& sum) const override;
  void add_hessian(const Increment& d, SymmetricBlocks& sum) const override;
  void add_unsymmetric(const Increment& d, Arms arms, UnsymmetricBlocks& sum) const override;
  /// An element may lose nine tenths of its volume at a time.
  double longest_step_fraction(const Increment& d, const Increment& change) const override;
  double stored_energy() const override;
  void add_stress(std::vector<Voigt>& stress) const override;

 private:
  /// An element in the step.
  struct State {
    Mat3 f;            ///< F₁
    Mat3 pull, push;   ///< J, the parts of V S that pull and push, as they bear on F₁
    Elastic elastic;   ///< of a small strain from here [Pa]: λ, and μ − λ ln J for μ
    ElementShape now;  ///< gradients where the element stands [1/m], its volume before the run [m³]
  };
  Mat3 bearer(int element, const Mat3& end) const;
  State state_of(int element, const Increment& d) const;
  ElementSums::Forces forces(int element, const Increment& d) const;
  ElementSums::Stiffness stiffness(int element, const Increment& d) const;
  ElementSums::WholeStiffness rest_of_tangent(int element, const Increment& d) const;
  double energy_of(int element, const Mat3& gradient) const;
  const BodySet& set_;
  EffectTolerances tolerances_;
  ElementSums sums_;
  bool mean_ = false;  ///< forces act along ½(F₀ + F₁)
};

}  // namespace talus
