#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "base/vector.hpp"

namespace talus {

/// A solid whose surface is triangles: closed, and crossing itself nowhere. It may be several bodies.
struct TriangleSolid {
  std::vector<Vec3> vertices;                 ///< m; in ImportedSolid relative to the model's origin
  std::vector<std::array<int, 3>> triangles;  ///< counter-clockwise seen from outside
  /// More than none for a height field over a flat base: so many triangles are the surface, and the same many come
  /// after them as their shadows on the base, turned around; the rest are the walls. The second half of the vertices
  /// lies below the first half, in the same order: a triangle and its shadow are the ends of a prism.
  int surface_triangles = 0;

  bool terrain_like() const { return surface_triangles > 0; }
  bool empty() const { return triangles.empty(); }
};

/// m³, by the divergence theorem; negative where the surface is inside out.
double volume_of(const TriangleSolid& solid);

/// Of the vertices.
Eigen::AlignedBox3d bounds_of(const TriangleSolid& solid);

}  // namespace talus
