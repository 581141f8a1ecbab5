#pragma once

#include <array>

#include "bodies/body_set.hpp"
#include "bodies/step_context.hpp"

namespace talus {

/// Two rigid bodies that move, and what all places where they meet (Meeting) have in common: how they have moved and
/// turned. The first carries these places.
class RigidPair {
 public:
  /// Degree-of-freedom blocks: centroids of the first and the second body, rotations of both.
  enum Part { first_centre, second_centre, first_turn, second_turn, part_count };

  RigidPair(const BodySet& set, const RigidBody& first, const RigidBody& second);

  bool is_of(const RigidBody& first, const RigidBody& second) const {
    return dof_blocks_[first_turn] == first.rotation_dof_block && dof_blocks_[second_turn] == second.rotation_dof_block;
  }
  const std::array<int, part_count>& dof_blocks() const { return dof_blocks_; }
  double first_radius() const { return first_radius_; }    ///< m, RigidBody::radius
  double second_radius() const { return second_radius_; }  ///< m

  /// All that hangs on D.
  struct State {
    long number = 0;   ///< another one for another D
    Vec3 apart;        ///< m, D₁ − D₂
    Vec3 mean_apart;   ///< m, x̄₁ − x̄₂, of the centroids in the middle of the step
    Mat3 first_turn;   ///< exp(θ̂₁) − 1
    Vec3 second_turn;  ///< φ₂, the Cayley vector
    Mat3 half_turned;  ///< 1 − φ̂₂/2
    Mat3 tangent;      ///< C(φ₂) / radius₂ [1/m], ∂φ₂ by the unknowns
  };
  const State& at(const Increment& d) const;

 private:
  double first_radius_, second_radius_;  // m
  Vec3 apart_;                           // m, of the centroids at the start of the step
  std::array<int, part_count> dof_blocks_;
  // Every contact effect asks for the same few D one after the other: the last one's answer is kept.
  mutable std::array<Vec3, part_count> unknowns_;
  mutable State state_;
};

}  // namespace talus
