#pragma once

#include <array>
#include <memory>
#include <vector>

#include "base/vector.hpp"

namespace talus {

/// The Delaunay triangulation, in plan, of some of many points, which grows until it is near enough to all of them.
class PlanTriangulation {
 public:
  /// No two of the points lie in one place in plan. They outlive this.
  explicit PlanTriangulation(const std::vector<Vec3>& points);
  ~PlanTriangulation();

  /// Points that are corners, whatever the tolerance.
  void take(const std::vector<int>& points);

  /// Edges that stay. The first end of one that crosses another one, which ends it; −1: none does.
  int keep_edges(const std::vector<std::array<int, 2>>& edges);

  /// Takes the point that is farthest from the surface, vertically, until none is farther than `tolerance`. What is
  /// there already spans a plane.
  void refine(double tolerance);

  /// Numbers of points, counter-clockwise seen from above. Faces at the rim that are thinner than `thin` [m] are left
  /// out: rounding makes them where points lie along a straight side.
  std::vector<std::array<int, 3>> triangles(double thin) const;

  /// The triangles on the inner side of the edges that were kept.
  std::vector<std::array<int, 3>> triangles_within_edges() const;

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

/// Corners of the convex hull in plan, counter-clockwise; those nearer than `thin` to the line of their neighbours are
/// left out. Fewer than three when all points lie on a line.
std::vector<int> hull_in_plan(const std::vector<Vec3>& points, double thin);

}  // namespace talus
