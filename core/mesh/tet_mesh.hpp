#pragma once

#include <array>
#include <vector>

#include "base/vector.hpp"

namespace talus {

/// Four-node tetrahedra; nodes 0,1,2 run counter-clockwise seen from node 3's far side, so that the volume
/// (p1−p0)×(p2−p0)·(p3−p0)/6 is positive.
struct TetMesh {
  std::vector<Vec3> nodes;  ///< m
  std::vector<std::array<int, 4>> tetrahedra;
};

/// A surface triangle, counter-clockwise seen from outside, and the joint that its facet lies on.
struct SurfaceTriangle {
  std::array<int, 3> nodes;
  int joint = -1;  ///< index into Project::joints; −1: on no cut
};

}  // namespace talus
