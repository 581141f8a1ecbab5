#pragma once

#include "bodies/body_set.hpp"
#include "mesh/moments.hpp"

namespace talus {

/// Where a block is and how it is turned.
struct BlockPose {
  Vec3 centroid = Vec3::Zero();      ///< m
  Mat3 rotation = Mat3::Identity();  ///< since the start of the run

  void archive(auto& state) { state(centroid, rotation); }
};

/// Fits poses to the nodes of all blocks, whatever they may do: the rotation is that of least squares (Kabsch 1976).
class PoseFit {
 public:
  explicit PoseFit(const BlockSystem& system);

  /// A block that is built fixed is taken as a whole: it does not turn.
  BlockPose pose(const BodySet& set, int block) const;
  /// The same of any node positions, undeformed and as they are: each a pointer to the block's first node [m].
  BlockPose pose(int block, const Vec3* reference, const Vec3* position) const;
  /// Mean over the undeformed block's volume of a vector that is given at its nodes; zero without tetrahedra.
  Vec3 mean(int block, const Vec3* nodal) const;
  std::vector<BlockPose> poses(const BodySet& set) const;  ///< one a block
  /// Mean of (x − c)(x − c)ᵀ over the block's volume, undeformed [m²]; zero where the block has no tetrahedra.
  const Mat3& spread(int block) const { return shapes_[static_cast<std::size_t>(block)].moments.spread; }
  double volume(int block) const {
    return shapes_[static_cast<std::size_t>(block)].moments.volume;
  }  ///< m³, of its tetrahedra

 private:
  struct Shape {
    std::vector<double> weight;  ///< a node: its fraction of the block's volume; none without tetrahedra
    VolumeMoments moments;
    bool fixed = false;
  };
  static Shape shape_of(const Block& block);
  std::vector<Shape> shapes_;
};

}  // namespace talus
