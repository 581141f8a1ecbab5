#pragma once

#include <array>
#include <vector>

#include "geometry/mesher/surfaces/triangle_solid.hpp"

namespace talus {

/// A flat part of a surface: its outline, and those of holes in it, each in order as the surface turns, so that the
/// part is on the left.
struct PlanarFace {
  std::vector<std::vector<int>> loops;  ///< numbers of vertices; the outline first
};

/// The surface with triangles in one plane, within 10⁻⁶ of its diagonal, as one face. Vertices in the middle of a
/// straight side are left out.
std::vector<PlanarFace> planar_faces(const TriangleSolid& solid);

/// Edges at which the surface bends by more than 20°, or ends: what is drawn as lines.
std::vector<std::array<int, 2>> feature_edges(const TriangleSolid& solid);

/// The triangles' parts that hang together by edges: number of the part by triangle, from 0.
std::vector<int> connected_parts(const TriangleSolid& solid);

}  // namespace talus
