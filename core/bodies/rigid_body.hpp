#pragma once

#include "base/vector.hpp"

namespace talus {

/// A block that moves and turns but keeps its shape. Its translation is that of a node at its centroid, its rotation in
/// a step an unknown of its own, radius·θ [m] with θ the rotation vector of the step: so all unknowns are lengths.
struct RigidBody {
  int body = 0;                          ///< into BodySet::bodies
  int centre = 0;                        ///< into NodeSet
  int rotation_dof_block = -1;           ///< numbered with those of nodes; −1 while it is held
  double mass = 0;                       ///< kg
  Mat3 inertia = Mat3::Zero();           ///< kg m², about the centroid, before the run
  double radius = 0;                     ///< m, of gyration about the axis that is hardest to turn
  double reach = 0;                      ///< m, of the node that is furthest from the centroid
  Mat3 rotation = Mat3::Identity();      ///< since the start of the run
  Vec3 angular_momentum = Vec3::Zero();  ///< N m s, about the centroid
  Vec3 moment = Vec3::Zero();            ///< N m, by which it changes

  bool touches = false;  ///< may touch another one that moves, in this step

  /// What changes from step to step.
  void archive(auto& state) { state(rotation, angular_momentum, moment, touches); }

  /// θ of an increment, whose unknowns are radius·θ.
  Vec3 theta(const Eigen::VectorXd& d) const { return d.segment<3>(3 * rotation_dof_block) / radius; }
  Mat3 inertia_now() const { return rotation * inertia * rotation.transpose(); }
  Vec3 spin() const;  ///< rad/s

  /// Jθ + ½ φ × Jθ [kg m²], with the inertia J at the start of a step and the Cayley vector φ of θ: divided by the
  /// length of the step, the angular momentum L of a body that turns by θ in the step without a moment. With it
  /// J⁻¹(Λ₀ᵀL + Λ₁ᵀL) is parallel to φ, so that ½ ω·L stays the same (Simo & Wong 1991, Lewis & Simo 1994); a turn
  /// about a principal axis is exact. Of a body that touches others it is Jφ + ½ φ × Jφ: then the moment of a force
  /// about the middle of its way is what changes L, and does all its work, but a turn by θ takes as long as one by φ
  /// should.
  Vec3 momentum_of(const Vec3& theta) const;
  /// Its derivative as the body turns on from θ [kg m²].
  Mat3 momentum_slope(const Vec3& theta) const;
};

}  // namespace talus
