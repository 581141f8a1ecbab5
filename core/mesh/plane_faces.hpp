#pragma once

#include <span>
#include <vector>

#include "base/vector.hpp"

namespace talus {

struct Surface;

/// A convex part of a plane whose nodes all lie on its outline; else a single triangle.
struct PlaneFace {
  std::vector<int> triangles;  ///< the largest first
  std::vector<int> outline;    ///< nodes, counter-clockwise as seen from outside
};

/// The faces that the triangles of a surface are parts of: those that lie in one plane and on one joint, where they
/// form a convex polygon without a node inside. Every other triangle is a face of its own. In the order of their first
/// triangles.
std::vector<PlaneFace> plane_faces(std::span<const Vec3> nodes, const Surface& surface);

/// The numbers of those plane faces whose plane all nodes lie below, but for rounding.
std::vector<int> supporting_faces(std::span<const Vec3> nodes, const Surface& surface);

/// But for rounding.
bool no_edge_is_concave(std::span<const Vec3> nodes, const Surface& surface);

}  // namespace talus
