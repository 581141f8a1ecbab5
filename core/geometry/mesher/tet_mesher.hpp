#pragma once

#include <string>

#include "base/error.hpp"
#include "geometry/mesher/surface_mesher.hpp"

namespace talus {

/// A block's mesh in coordinates relative to the model's origin.
struct MeshedShape {
  std::vector<Vec3> nodes;
  std::vector<std::array<int, 4>> tetrahedra;
  std::vector<std::array<int, 3>> triangles;  ///< the surface, counter-clockwise seen from outside
  std::vector<int> triangle_joints;
};

/// Fills a block's surface with tetrahedra, in a gmsh model of its own so that one bad block spoils no other:
/// Delaunay, one thread, the same bits each time. `size`: m, the length that edges aim at where no refinement says
/// another; `volume`: m³, the block's. Throws InputError at `place` when gmsh fails or the mesh does not fill the
/// block.
MeshedShape fill_with_tetrahedra(const SurfaceMesh& surface, double size, std::span<const MeshRefinement> refinements,
                                 double volume, const std::string& place);

/// A block that touches itself along an edge: contact knows surfaces alone of which every edge has two triangles.
class TouchesItself : public InputError {
 public:
  TouchesItself(const std::string& place, const Vec3& at);
  const Vec3& at() const { return at_; }  ///< m, the middle of the edge, relative to the model's origin

 private:
  Vec3 at_;
};

/// Throws TouchesItself at `place`.
void require_two_triangles_an_edge(std::span<const Vec3> nodes, std::span<const std::array<int, 3>> triangles,
                                   const std::string& place);

}  // namespace talus
