#pragma once

#include "bodies/body_set.hpp"

namespace talus {

/// How a block as a whole has moved since the start of the run.
struct BlockMotion {
  double relative_volume_change = 0;
  Vec3 displacement = Vec3::Zero();  ///< m, of the centroid
  Vec3 velocity = Vec3::Zero();      ///< m/s, of the centroid
  double rotation = 0;               ///< rad, of the nearest rotation to the mean deformation gradient

  void archive(auto& state) { state(relative_volume_change, displacement, velocity, rotation); }
};

BlockMotion block_motion(const BodySet& set, int body);

/// Where a place on a body lay before the run: it goes with the body's nearest node [m].
Vec3 place_before_run(const BodySet& set, const Vec3& place, int body);

/// A material point of a block: fixed weights of the corners of the tetrahedron that holds it.
struct MaterialPoint {
  int body = 0;
  int tetrahedron = 0;         ///< of the block's mesh
  std::array<int, 4> nodes{};  ///< into NodeSet
  std::array<double, 4> weights{};

  /// Σ weight · value over the four corners.
  Vec3 at(const std::vector<Vec3>& values) const;
};

/// The point of the block nearest to `where` [m]: inside its tetrahedra, or on the nearest of them when `where` lies
/// outside by no more than `tolerance` [m]; otherwise an InputError at `place`.
MaterialPoint material_point(const BlockSystem& system, const std::string& block, const Vec3& where, double tolerance,
                             const std::string& place);

}  // namespace talus
