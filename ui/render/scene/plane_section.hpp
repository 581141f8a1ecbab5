#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/vector.hpp"

/// The part of a joint's plane that lies in the rock.
namespace talus {

/// A closed surface, its triangles counter-clockwise seen from outside. Refers to what its owner keeps.
struct RockSurface {
  std::span<const Vec3> points;                     ///< m
  std::span<const std::array<int, 3>> triangles{};  ///< indices of points
};

using FlatTriangle = std::array<Vec3, 3>;

/// Where the plane through `point` across `normal` lies inside the surface, as triangles.
std::vector<FlatTriangle> plane_section(const RockSurface& rock, const Vec3& point, const Vec3& normal);

/// The side of a plane that `inwards` points to.
struct HalfSpace {
  Vec3 point = Vec3::Zero();     ///< m
  Vec3 inwards = Vec3::UnitZ();  ///< of any length
};

/// What of the triangles lies in all half-spaces.
std::vector<FlatTriangle> clipped(std::vector<FlatTriangle> triangles, std::span<const HalfSpace> to);

/// Half-spaces of the sides of a convex polygon in the plane across `normal`; corners in either sense.
std::vector<HalfSpace> sides_of(std::span<const Vec3> corners, const Vec3& normal);

/// Triangles that a flat polygon without crossings is made of.
std::vector<FlatTriangle> triangles_of(std::span<const Vec3> corners);

/// Edges that one triangle alone has: the outline of what they cover together.
std::vector<std::array<Vec3, 2>> outline_of(std::span<const FlatTriangle> triangles);

}  // namespace talus
