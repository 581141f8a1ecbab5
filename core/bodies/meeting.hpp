#pragma once

#include <span>

#include "bodies/rigid_pair.hpp"

namespace talus {

/// Two rigid bodies that act on each other at one place, which the first carries: where its point is in the middle of
/// the step. They move against each other there by
///   u = ±[D₁ + φ₁ × ℓ₁ − D₂ − φ₂ × ℓ₂],  ℓ₂ = x̄₁ − x̄₂ + ℓ₁  [m]
/// with the Cayley vectors φ of their rotations, the mean arm ℓ₁ of the first body's point and the centroids x̄ in the
/// middle of the step. A force turns the bodies by ℓ₁ and −ℓ₂: it does the work of u, and as both moments are about one
/// place, the step keeps angular momentum (docs/theory.md, "One place"). Both bodies touch (RigidBody::touches).
class Meeting {
 public:
  /// `weight`: of the first body, +1 or −1; `arm`: of its point, in space at the start of the step [m].
  Meeting(double weight, const Vec3& arm) : weight_(weight), arm_(arm) {}

  /// Which of two bodies with these weights of their nodes, above 0 those of body 0, carries the place: the one whose
  /// vertex it is, else body 0.
  static int carrier(std::span<const double> weights);

  /// What hangs on D.
  struct Levers {
    Vec3 end;     ///< m, of the first body's point at the end of the step
    Vec3 first;   ///< m, ℓ₁
    Vec3 second;  ///< m, ℓ₂
  };
  const Levers& levers(const RigidPair::State& pair) const;
  double weight() const { return weight_; }

  Vec3 increment(const RigidPair::State& pair) const;  ///< u [m]

 private:
  double weight_;
  Vec3 arm_;
  mutable long number_ = 0;  // of the pair's state at which the levers were taken
  mutable Levers levers_;
};

/// Forces at places where two rigid bodies meet, added up before they go to the bodies.
class MeetingForces {
 public:
  void add(const RigidPair::State& state, const Meeting& place, const Vec3& force, Arms arms);
  /// Calls use(degree-of-freedom block, force on it) of Σ levers · force; with the arms at the end of the step of
  /// Σ (∂u/∂D)ᵀ · force [N]. It is zero from then on.
  void take_out(const RigidPair& pair, const RigidPair::State& state, Arms arms, const auto& use) {
    if (!any_) return;
    const Forces forces = on_parts(pair, state, arms);
    for (int part = 0; part < RigidPair::part_count; ++part) use(pair.dof_blocks()[part], forces[part]);
    *this = {};
  }

 private:
  using Forces = std::array<Vec3, RigidPair::part_count>;
  Forces on_parts(const RigidPair& pair, const RigidPair::State& state, Arms arms) const;

  bool any_ = false;
  Vec3 force_ = Vec3::Zero();                                        // N, on the first body
  Vec3 first_moment_ = Vec3::Zero(), second_moment_ = Vec3::Zero();  // N m
};

}  // namespace talus
