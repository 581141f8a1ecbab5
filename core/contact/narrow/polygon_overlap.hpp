#pragma once

#include <Eigen/Core>
#include <array>

#include "model/tolerances.hpp"

namespace talus {

using Vec2 = Eigen::Vector2d;
using Triangle2 = std::array<Vec2, 3>;

inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// A convex polygon, counter-clockwise, and the part of its area that each corner carries.
struct OverlapPolygon {
  std::array<Vec2, 9> corners;
  std::array<double, 9> weights;
  int count = 0;
  double area = 0;
};

/// Overlap of two counter-clockwise triangles.
OverlapPolygon overlap(const Triangle2& a, const Triangle2& b, const ContactTolerances& tolerances);

/// Gives the corners their weights, parts of the area: Σ wᵢ f(Pᵢ) is the integral of f for every linear f. They are the
/// barycentric coordinates of the centroid (Wachspress 1975): a corner where the outline runs straight on has no
/// weight, so that weights stay continuous when corners merge, part or slip along an edge, and a sliver that rounding
/// cuts off changes nothing. Corners in one place are merged; a polygon without an area is left empty.
void distribute_area(OverlapPolygon& polygon, const ContactTolerances& tolerances);

}  // namespace talus
