#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "model/tolerances.hpp"

namespace talus {

using Vec2 = Eigen::Vector2d;

inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// A convex polygon, counter-clockwise, and the part of its area that each corner carries.
struct OverlapPolygon {
  std::vector<Vec2> corners;
  std::vector<double> weights;  ///< a corner
  double area = 0;

  std::vector<Vec2> cut;        ///< scratch …
  std::vector<double> sectors;  ///< … that keeps its room
};

/// Overlap of two convex polygons, both counter-clockwise.
void overlap(std::span<const Vec2> a, std::span<const Vec2> b, const ContactTolerances& tolerances,
             OverlapPolygon& polygon);

/// Gives the corners their weights, parts of the area: Σ wᵢ f(Pᵢ) is the integral of f for every linear f. They are the
/// barycentric coordinates of the centroid (Wachspress 1975): a corner where the outline runs straight on has no
/// weight, so that weights stay continuous when corners merge, part or slip along an edge, and a sliver that rounding
/// cuts off changes nothing. Corners in one place are merged; a polygon without an area is left empty.
void distribute_area(OverlapPolygon& polygon, const ContactTolerances& tolerances);

}  // namespace talus
