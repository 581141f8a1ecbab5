#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/vector.hpp"
#include "render/scene/surface_tree.hpp"

/// The part of a joint's plane that lies in the rock.
namespace talus {

/// The side of a plane that `inwards` points to.
struct HalfSpace {
  Vec3 point = Vec3::Zero();     ///< m
  Vec3 inwards = Vec3::UnitZ();  ///< of any length
};

using FlatTriangle = std::array<Vec3, 3>;
using Edge = std::array<Vec3, 2>;

/// An area of a plane, with holes and in several pieces as it comes. It is kept as the edges around it, in no order:
/// what lies behind an odd number of them is inside.
class PlaneSection {
 public:
  /// Where the plane through `point` across `normal` lies inside the rock.
  PlaneSection(const RockSurface& rock, const Vec3& point, const Vec3& normal);
  PlaneSection(const SurfaceTree& rock, const Vec3& point, const Vec3& normal);
  /// All of a polygon in that plane, m.
  static PlaneSection of_polygon(std::span<const Vec3> corners, const Vec3& point, const Vec3& normal);

  /// Only what lies on this side is kept. `bordered`: the new border is a part of the outline.
  void clip(const HalfSpace& to, bool bordered = true);

  /// Triangles that cover it, m.
  std::vector<FlatTriangle> triangles() const;
  std::vector<Edge> outline() const;

 private:
  using Vec2 = Eigen::Vector2d;
  struct Piece {
    Vec2 from, to;
    bool bordered = true;
  };
  PlaneSection(const Vec3& point, const Vec3& normal);
  void cross(const RockSurface& rock, const std::array<int, 3>& triangle, const Vec3& normal);
  Vec2 flat(const Vec3& place) const { return {along_.dot(place - point_), across_.dot(place - point_)}; }
  Vec3 place(const Vec2& flat) const { return point_ + flat.x() * along_ + flat.y() * across_; }

  Vec3 point_, along_, across_;
  std::vector<Piece> edges_;
};

/// Half-spaces of the sides of a convex polygon in the plane across `normal`, side by side; corners in either sense.
std::vector<HalfSpace> sides_of(std::span<const Vec3> corners, const Vec3& normal);

/// Triangles that a flat polygon without crossings is made of.
std::vector<FlatTriangle> triangles_of(std::span<const Vec3> corners);

}  // namespace talus
