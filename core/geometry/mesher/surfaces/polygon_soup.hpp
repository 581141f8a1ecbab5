#pragma once

#include <array>
#include <vector>

#include "base/vector.hpp"

namespace talus {

/// Polygons as files have them: nothing is known yet of how they hang together.
struct PolygonSoup {
  std::vector<Vec3> points;                ///< m, once they are scaled and placed
  std::vector<std::vector<int>> polygons;  ///< numbers of points, in order
};

/// Triangles of a soup whose points in one place are one.
struct TriangleSoup {
  std::vector<Vec3> points;
  std::vector<std::array<int, 3>> triangles;
  std::vector<Vec3> joined;    ///< where a point went into another one
  std::vector<Vec3> left_out;  ///< where a triangle was left without area, or was there twice
};

/// Polygons as triangles; points within 10⁻⁶ of the soup's diagonal of each other are one: files have rounded
/// coordinates.
TriangleSoup welded(const PolygonSoup& soup);

}  // namespace talus
