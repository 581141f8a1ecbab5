#pragma once

#include "bodies/element_sums.hpp"
#include "effects/effect.hpp"
#include "model/solver_tolerances.hpp"

namespace talus {

/// Strain energy of linear rock, measured from the undeformed shape in the rotated frame (docs/theory.md). With the
/// deformation gradient F = R S of an element and E = S − I:
///   Π = Σ_e V [μ E:E + λ/2 (tr E)²]  [J],   P = ∂Π/∂F = R [2μE + λ tr(E) I]
/// A block that only turns neither grows nor gains stress. In dynamic steps whose forces are taken at the end, P acts
/// along the mean rotation of the step, ½(R₀ + R₁) Rᵀ₁ P₁: along the end's alone it would do work on the chord of a
/// stressed block that turns, and brake its spin; strains stay those of the end, which takes energy from vibrations.
/// The Hessian is the exact one (dR from (tr S I − S)⁻¹; e.g. McAdams et al. 2011) but for the part of compressed
/// elements that would be negative. The rest of the tangent of the mean rotation is the unsymmetric part, of elements
/// that turn in the step: without it Newton's method leads nowhere where a stiff block spins.
/// An element keeps its stiffness while its deformation gradient hardly changes: in a block that slides for ever.
class CorotationalElasticity final : public Effect {
 public:
  explicit CorotationalElasticity(const BodySet& set, const EffectTolerances& tolerances = {})
      : set_(set), tolerances_(tolerances), sums_(set), kept_(set.element_numbers), turned_(set.element_numbers) {}
  EffectKind kind() const override { return EffectKind::elasticity; }
  EnergyAccount account() const override { return EnergyAccount::elastic; }
  bool quadratic() const override { return false; }
  bool smooth() const override { return true; }
  void begin_step(const StepContext& step) override;
  void add_couplings(std::vector<std::pair<int, int>>& couplings) const override;
  double energy(const Increment& d) const override;
  void add_gradient(const Increment& d, Arms arms, Eigen::VectorXd& sum) const override;
  void add_hessian(const Increment& d, SymmetricBlocks& sum) const override;
  void add_unsymmetric(const Increment& d, Arms arms, UnsymmetricBlocks& sum) const override;
  void archive(StateArchive& state) override { state(kept_); }
  double stored_energy() const override;
  void add_stress(std::vector<Voigt>& stress) const override;

 private:
  ElementSums::Forces forces(int element, const Increment& d) const;
  ElementSums::Stiffness stiffness(int element, const Increment& d) const;
  /// Its stiffness here, or where it was deformed nearly as now.
  const ElementSums::Stiffness& keep_stiffness(int element, const Increment& d) const;
  ElementSums::WholeStiffness rest_of_tangent(int element, const Increment& d) const;
  double energy_of(int element, const Mat3& gradient) const;
  /// Its rotation; forces, stiffness and the rest of the tangent ask for that of the same deformation gradient.
  const Mat3& rotation(int element, const Mat3& gradient) const;
  /// What an element's stiffness was, and with which deformation gradient.
  struct Kept {
    Mat3 gradient = Mat3::Zero();
    ElementSums::Stiffness stiffness;

    void archive(auto& state) { state(gradient, stiffness); }
  };

  struct Turned {
    Mat3 gradient = Mat3::Identity(), rotation = Mat3::Identity();
  };

  const BodySet& set_;
  EffectTolerances tolerances_;
  ElementSums sums_;
  mutable std::vector<Kept> kept_;      ///< by the elements' numbers
  mutable std::vector<Turned> turned_;  ///< as they were asked for last, by the same
  mutable std::vector<int> turning_;    ///< elements, in this iterate
  std::vector<Mat3> start_;  ///< R₀ of each element of linear rock, where the mean rotation is asked for; else none
};

}  // namespace talus
