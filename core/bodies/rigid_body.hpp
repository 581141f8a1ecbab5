#pragma once

#include "base/vector.hpp"

namespace talus {

/// A block that moves and turns but keeps its shape. Its translation is that of a node at its centroid, its rotation in
/// a step an unknown of its own, radius·θ [m] with θ the rotation vector of the step: so all unknowns are lengths.
struct RigidBody {
  int body = 0;                          ///< into BodySet::bodies
  int centre = 0;                        ///< into NodeSet
  int rotation_freedom = -1;             ///< numbered with the nodes' freedoms; −1 while it is held
  double mass = 0;                       ///< kg
  Mat3 inertia = Mat3::Zero();           ///< kg m², about the centroid, before the run
  double radius = 0;                     ///< m, of gyration about the axis that is hardest to turn
  double reach = 0;                      ///< m, of the node that is furthest from the centroid
  Mat3 rotation = Mat3::Identity();      ///< since the start of the run
  Vec3 angular_momentum = Vec3::Zero();  ///< N m s, about the centroid
  Vec3 moment = Vec3::Zero();            ///< N m, by which it changes

  /// θ of an increment, whose unknowns are radius·θ.
  Vec3 theta(const Eigen::VectorXd& d) const { return d.segment<3>(3 * rotation_freedom) / radius; }
  Mat3 inertia_now() const { return rotation * inertia * rotation.transpose(); }
  Vec3 spin() const;  ///< rad/s

  /// Jθ + ½ φ × Jθ with the inertia J at the start of a step and the Cayley vector φ of θ: over its length the angular
  /// momentum L of a body that turns by θ in it without a moment, for that makes J⁻¹(Λ₀ᵀL + Λ₁ᵀL) parallel to φ, by
  /// which ½ ω·L stays the same (Simo & Wong 1991, Lewis & Simo 1994; a turn about a principal axis is exact besides)
  /// [kg m²]. And its derivative as the body turns on from θ.
  Vec3 momentum_of(const Vec3& theta) const;
  Mat3 momentum_slope(const Vec3& theta) const;
};

}  // namespace talus
