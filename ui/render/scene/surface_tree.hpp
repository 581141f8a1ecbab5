#pragma once

#include <Eigen/Geometry>
#include <array>
#include <span>
#include <vector>

#include "base/vector.hpp"

namespace talus {

/// A closed surface, its triangles counter-clockwise seen from outside. Refers to what its owner keeps.
struct RockSurface {
  std::span<const Vec3> points{};                   ///< m
  std::span<const std::array<int, 3>> triangles{};  ///< indices of points
};

/// A closed surface that is asked again and again what a plane meets, or what lies in it: boxes in boxes around its
/// triangles, so that few of them are looked at. It keeps a copy of the surface.
class SurfaceTree {
 public:
  explicit SurfaceTree(const RockSurface& rock);

  RockSurface rock() const { return {points_, triangles_}; }
  /// Triangles that the plane through `point` across `normal` may cross: all that do, and some beside.
  std::vector<int> near_plane(const Vec3& point, const Vec3& normal) const;
  /// Whether a triangle may reach into the ball; false means that the surface is outside it.
  bool may_reach(const Vec3& centre, double radius) const;
  /// Whether a point that does not lie on the surface is inside.
  bool holds(const Vec3& point) const;

 private:
  struct Node {
    Eigen::AlignedBox3d box;
    int begin, end;  ///< triangles
    int right;       ///< child; the left one follows its parent; 0: a leaf
  };
  int build(int begin, int end);
  /// Calls take(triangle) for the triangles in the leaves that are reached through boxes for which wanted(box).
  template <class Wanted, class Take>
  void visit(const Wanted& wanted, const Take& take) const;

  std::vector<Vec3> points_;
  std::vector<std::array<int, 3>> triangles_;  ///< those that lie together follow each other
  std::vector<Node> nodes_;
};

}  // namespace talus
