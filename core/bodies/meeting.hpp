#pragma once

#include <array>
#include <span>

#include "bodies/body_set.hpp"
#include "bodies/step_context.hpp"

namespace talus {

/// Two rigid bodies that act on each other at one place, which the first carries: where its point is in the middle of
/// the step. They move against each other there by
///   u = ±[D₁ + φ₁ × ℓ₁ − D₂ − φ₂ × ℓ₂],  ℓ₂ = x̄₁ − x̄₂ + ℓ₁  [m]
/// with the Cayley vectors φ of their rotations, the mean arm ℓ₁ of the first body's point and the centroids x̄ in the
/// middle of the step. A force turns the bodies by ℓ₁ and −ℓ₂: it does the work of u, and as both moments are about one
/// place, the step keeps angular momentum (docs/theory.md, "One place"). Both bodies touch (RigidBody::touches).
class Meeting {
 public:
  /// How a body takes part: its own weight, +1 or −1, and its point's arm in space [m] at the start of the step.
  struct Side {
    int body;  // into BodySet::bodies
    double weight;
    Vec3 arm;
  };
  /// Degree-of-freedom blocks: centroids of the first and the second body, rotations of both.
  enum Part { first_centre, second_centre, first_turn, second_turn, part_count };
  /// How u, ℓ₁ and ℓ₂ change as the parts move and turn on.
  struct Slope {
    std::array<Mat3, part_count> place;   ///< ∂u/∂D, in unknowns of the step
    std::array<Mat3, part_count> levers;  ///< its counterpart of forces: they add levers · force
  };

  Meeting(const BodySet& set, const Side& first, const Side& second);

  /// Which of two bodies with these weights of their nodes, above 0 those of body 0, carries the place: the one whose
  /// vertex it is, else body 0.
  static int carrier(std::span<const double> weights);

  const std::array<int, part_count>& dof_blocks() const { return dof_blocks_; }
  Vec3 increment(const Increment& d) const;  ///< u [m]
  void add_force(const Increment& d, const Vec3& force, Arms arms, Eigen::VectorXd& sum) const;
  Slope slope(const Increment& d) const;
  /// A block of ∂/∂D of levers · force at a constant force.
  struct Turning {
    Part row, column;
    Mat3 block;
  };
  std::array<Turning, 4> turning(const Increment& d, const Vec3& force) const;

 private:
  /// All that hangs on D.
  struct State {
    std::array<Vec3, part_count> unknowns;
    Vec3 turn;          // φ₂, the Cayley vector
    Vec3 first_arm;     // m, of the first body's point at the end of the step
    Vec3 first_lever;   // m, ℓ₁
    Vec3 second_lever;  // m, ℓ₂
  };
  const State& at(const Increment& d) const;

  double weight_;                        // of the first body
  Vec3 arm_;                             // m, of its point at the start of the step
  double first_radius_, second_radius_;  // m
  Vec3 apart_;                           // m, of the centroids at the start of the step
  std::array<int, part_count> dof_blocks_;
  // Every contact effect asks for the same few D one after the other: the last one's answer is kept.
  mutable State state_;
};

}  // namespace talus
