#pragma once

#include <array>
#include <span>
#include <vector>

#include "mesh/plane_faces.hpp"
#include "mesh/tet_mesh.hpp"

namespace talus {

/// An edge of a closed triangulated surface and the two triangles it joins.
struct SurfaceEdge {
  std::array<int, 2> nodes;
  std::array<int, 2> triangles;
};

/// A block's surface with what contact asks of it: edges, smooth faces, rings, corners. Made once from the undeformed
/// mesh; positions are given to whoever needs them. Node numbers are the block's own.
struct Surface {
  std::vector<SurfaceTriangle> triangles;
  std::vector<std::array<int, 3>> triangle_edges;  ///< edge opposite to each of the triangle's nodes
  std::vector<SurfaceEdge> edges;
  std::vector<int> smooth_face;  ///< a triangle: the one it belongs to; they end at edges of 2° and more
  int smooth_face_count = 0;
  std::vector<PlaneFace> faces;        ///< every triangle is part of one
  bool is_convex = false;              ///< no edge is concave, but for rounding
  std::vector<int> supporting;         ///< numbers of `faces` whose plane all nodes lie below, but for rounding
  std::vector<std::vector<int>> ring;  ///< a node: its neighbours along surface edges
  std::vector<bool> corner;            ///< a node where sharp edges do not pass straight through
  double size = 0;                     ///< m, √(2 · mean triangle area)
};

/// Throws std::invalid_argument when the triangles do not form a closed, consistently oriented surface.
Surface make_surface(std::span<const Vec3> nodes, std::vector<SurfaceTriangle> triangles);

}  // namespace talus
