#pragma once

#include <array>

#include "bodies/meeting.hpp"

namespace talus {

/// Rows and columns of what two rigid bodies do to each other: centroids, the first's rotation, the second's. The
/// second centroid has the blocks of the first with the other sign.
using PairBlocks = std::array<std::array<Mat3, 3>, 3>;

/// Springs at all places where two rigid bodies meet, Σ Bᵀ K B [N/m], with symmetric K and
///   B = ∂u/∂D = ±[P, −P, −P â/r₁, l̂ T],  P = 1 − φ̂₂/2
/// of each place, the arm a at the end of the step, the second lever l (Meeting), and T of RigidPair: they are added up
/// before they are turned into blocks of the pair.
class PairSprings {
 public:
  PairSprings() { clear(); }
  void clear();
  void add(const RigidPair::State& pair, const Meeting& place, const Mat3& spring);
  /// The lower triangle.
  void find(const RigidPair& pair, const RigidPair::State& state, PairBlocks& blocks) const;

 private:
  PairBlocks sums_;  // Σ rows · K · columns: rows Pᵀ, â Pᵀ, l̂, columns P, P â, l̂; row ≥ column
};

/// What is beside it in the derivative of forces: Σ L (K + E) B − Bᵀ K B, where a force adds L · force, and how moments
/// of forces that stay change with their levers [N/m]. E is by how much forces fall otherwise, as friction does with
/// the normal force.
class UnsymmetricPairSprings {
 public:
  UnsymmetricPairSprings() { clear(); }
  void clear();
  /// `force`: on the first body [N].
  void add(const RigidPair::State& pair, const Meeting& place, const Vec3& force, const Mat3& spring,
           const Mat3& other);
  void find(const RigidPair& pair, const RigidPair::State& state, PairBlocks& blocks) const;

 private:
  PairSprings symmetric_;
  PairBlocks sums_;  // rows 1, m̂ with the first lever m, l̂, columns P, P â, l̂
  Mat3 force_;       // f̂
  Mat3 force_arm_;   // f̂ â
};

}  // namespace talus
