#pragma once

#include "effects/effect.hpp"

/// Inertia of rigid bodies (not in the paper), for any integrator of TimeIntegration's family. The centroid moves as a
/// point of the body's mass. Turning, the integrator is applied to the angular momentum L as a whole,
///   L₁ = L₀ + Δ[(1 − γ) Ȧ₀ + γ Ȧ₁],   Jθ + ½ φ × Jθ = Δ L₀ + Δ²[(½ − β) Ȧ₀ + β Ȧ₁] − ¼ Δ φ × (L₁ − L₀),
/// with Ȧ its rate, the moment of all forces, θ the rotation of the step and φ its Cayley vector
/// (RigidBody::momentum_of): without a moment L stays the same to round-off, and a spin about a principal axis is
/// exact. With one, and β = ½, γ = 1, what turns the body is the mean of L in its own axes, ½ (Λ₀ᵀL₀ + Λ₁ᵀL₁), so that
/// ½ ω·L changes by the work of the moment, Ȧ₁·θ, to round-off (Simo & Wong 1991); the last term is what that mean is
/// less than that of L in fixed ones.
namespace talus {

/// The forces and moments that the increment `d` asks for, on the left of the equation of motion [N]. `bodies`: of
/// BodySet::turning.
void add_rigid_inertia(const BodySet& set, std::span<const int> bodies, const StepContext& step, const Increment& d,
                       Eigen::VectorXd& sum);
/// Their derivative at d = 0, and the derivative at `d` less that [N/m].
void add_rigid_mass(const BodySet& set, const StepContext& step, SymmetricBlocks& sum);
void add_rigid_turning(const BodySet& set, std::span<const int> bodies, const StepContext& step, const Increment& d,
                       UnsymmetricBlocks& sum);

/// Ȧ₁, the rate of angular momentum at the end of the step [N m].
Vec3 end_moment(const BodySet& set, const RigidBody& body, const StepContext& step, const Increment& d);
/// Moves angular momenta and their rates on by `d`; to zero in a static stage.
void accept_rigid(BodySet& set, const StepContext& step, const Increment& d);

/// ½ m v² + ½ ω·L of a body [J], and of all that turn.
double kinetic_energy(const BodySet& set, const RigidBody& body);
double rigid_kinetic_energy(const BodySet& set);

}  // namespace talus
