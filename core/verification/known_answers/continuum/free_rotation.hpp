#pragma once

#include "bodies/body_set.hpp"

/// Rotation without torque: Euler's equations, and what the bodies of a simulation do.
namespace talus {

/// ω in the body's axes after a time [rad/s], from principal moments of inertia (any unit) by Euler's equations:
/// I₁ω̇₁ = (I₂ − I₃) ω₂ω₃ and so on; classical Runge–Kutta, `steps` of them.
Vec3 free_angular_velocity(const Vec3& moments, const Vec3& initial, double time, int steps);

/// The first `count` times [s] at which component `axis` of ω is zero.
std::vector<double> zero_crossings(const Vec3& moments, const Vec3& initial, int axis, int count);

/// Σ ∫ ρ x × v over all movable blocks, exact for tetrahedra [kg m²/s].
Vec3 angular_momentum(const BodySet& bodies);

}  // namespace talus
