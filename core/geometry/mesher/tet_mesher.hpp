#pragma once

#include "geometry/mesher/block_cutter.hpp"

namespace talus {

/// A block's mesh in coordinates relative to the model's origin.
struct MeshedShape {
  std::vector<Vec3> nodes;
  std::vector<std::array<int, 4>> tetrahedra;
  std::vector<std::array<int, 3>> triangles;  ///< the surface, counter-clockwise seen from outside
  std::vector<int> triangle_joints;
};

/// Meshes blocks of gmsh's current model one by one, each by itself: Delaunay, one thread, the same bits each time.
class TetMesher {
 public:
  explicit TetMesher(const PlaneTable& planes);

  /// `size`: m, the length that edges aim at. Nodes on flat facets lie on the table's planes to the last digit.
  /// Throws InputError at `place` when gmsh fails or the mesh does not fill the block.
  MeshedShape mesh(const CutBlock& block, double size, const std::string& place);

 private:
  const PlaneTable& planes_;
};

}  // namespace talus
