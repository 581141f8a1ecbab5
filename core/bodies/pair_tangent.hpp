#pragma once

#include <array>

#include "bodies/meeting.hpp"

namespace talus {

/// Rows and columns of what two rigid bodies do to each other: centroids, the first's rotation, the second's. The
/// second centroid has the blocks of the first with the other sign.
using PairBlocks = std::array<std::array<Mat3, 3>, 3>;

/// How a force at a point changes as the point moves.
struct PointTangent {
  Vec3 force = Vec3::Zero();     ///< N, as Attachments::add_force is given it
  Mat3 spring = Mat3::Zero();    ///< N/m, symmetric, by how much the force falls
  Mat3 other = Mat3::Zero();     ///< N/m, by how much it falls beside that, as friction does with the normal force
  Mat3 set_down = Mat3::Zero();  ///< N/m, of a point that is open and counts as closed, in the symmetric part alone
  bool bears = false;            ///< there is a force or a spring
  bool has_other = false, has_set_down = false;
};

/// The derivative of the forces at all places where two rigid bodies meet [N/m], added up before it is turned into
/// blocks of the pair. Its symmetric part is that of the springs, Σ Bᵀ K B, with symmetric K and
///   B = ∂u/∂D = ±[P, −P, −P â/r₁, l̂ T],  P = 1 − φ̂₂/2
/// of each place, the arm a at the end of the step, the second lever l (Meeting), and T of RigidPair. Beside it is
/// Σ L (K + E) B − Bᵀ K B, where a force adds L · force and E is what forces fall by beside K, and how moments of
/// forces that stay change with their levers.
class PairTangent {
 public:
  PairTangent() { clear(); }
  void clear();
  void add(const RigidPair::State& pair, const Meeting& place, const PointTangent& at);
  /// The lower triangle.
  void find_symmetric(const RigidPair& pair, const RigidPair::State& state, PairBlocks& blocks) const;
  void find_unsymmetric(const RigidPair& pair, const RigidPair::State& state, PairBlocks& blocks) const;

 private:
  using Columns = std::array<Mat3, 3>;
  static void add_springs(const RigidPair::State& pair, const Meeting::Levers& at, const Columns& columns,
                          PairBlocks& sums);
  static void find(const PairBlocks& sums, const RigidPair& pair, const RigidPair::State& state, PairBlocks& blocks);

  PairBlocks springs_;   // Σ rows · K · columns: rows Pᵀ, â Pᵀ, l̂, columns P, P â, l̂; row ≥ column
  PairBlocks set_down_;  // the same of points that count as closed
  PairBlocks sums_;      // rows 1, m̂ with the first lever m, l̂, columns P, P â, l̂, of K + E
  Mat3 force_;           // f̂
  Mat3 force_arm_;       // f̂ â
  bool has_set_down_;
};

}  // namespace talus
