#pragma once

#include <optional>
#include <vector>

#include "bodies/body_set.hpp"
#include "contact/broad/box.hpp"
#include "mesh/surface.hpp"

namespace talus {

/// Planes that all nodes of a block lie behind: what lies before one of them is outside, without a look at the surface.
class OuterPlanes {
 public:
  /// Along the block's triangles, some of them where they are many.
  OuterPlanes(const std::vector<SurfaceTriangle>& triangles, const std::vector<Vec3>& positions, int first, int count);
  /// Both lie before one of the planes.
  bool lie_before_one(const Vec3& a, const Vec3& b) const;

 private:
  struct Plane {
    Vec3 normal, at;
    double farthest = 0;  ///< of the nodes along the normal from there, and what rounding may add
  };
  std::vector<Plane> planes_;
};

/// How deep a point of one block lies inside another.
struct Interpenetration {
  double depth = 0;           ///< of the local mesh size: the smaller of the two blocks', a fixed one's does not count
  int block = -1, into = -1;  ///< indices of blocks; −1: nothing lies inside anything
};

/// Looks whether blocks lie in each other, by geometry alone: it shares nothing with the search for contacts, so that
/// what that one misses is seen. Points are nodes, centroids of tetrahedra, and the middles of what of an edge lies
/// between two triangles that it goes through; a point is inside where the surface winds about it; its depth is the
/// distance to the nearest triangle.
class InterpenetrationCheck {
 public:
  /// `system` outlives the check.
  explicit InterpenetrationCheck(const BlockSystem& system);
  /// The deepest of those deeper than `known`, with the blocks where they are now.
  Interpenetration deepest(const BodySet& bodies, double known = 0) const;

 private:
  std::vector<Vec3> points_of(const BodySet& bodies, int block) const;
  /// The middles of what of the block's edges goes through another one, which lies in `box` and behind `planes`.
  std::vector<Vec3> inner_edge_points(const BodySet& bodies, int block, int other, const Box& box,
                                      const OuterPlanes& planes) const;
  /// Deepest of `points` in the block's surface [m], or `known` where none is deeper.
  double depth_in(const BodySet& bodies, int block, const Box& box, const OuterPlanes& planes,
                  const std::vector<Vec3>& points, double known) const;

  const BlockSystem& system_;
  std::vector<Surface> surfaces_;
};

/// Solid angle of a closed surface as seen from a point, over that of the whole sphere: 1 inside, 0 outside. `first`:
/// where the block's nodes begin in `positions`. Source: van Oosterom & Strackee 1983.
double winding_number(const Vec3& point, const std::vector<SurfaceTriangle>& triangles,
                      const std::vector<Vec3>& positions, int first);

/// Distance of a point from a triangle [m].
double distance_to_triangle(const Vec3& point, const Vec3& a, const Vec3& b, const Vec3& c);

/// Where a segment goes through a triangle, as a share of its length; nothing where it passes by, or lies in its plane.
std::optional<double> fraction_to_triangle(const Vec3& from, const Vec3& to, const Vec3& a, const Vec3& b,
                                           const Vec3& c);

}  // namespace talus
