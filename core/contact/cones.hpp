#pragma once

#include <array>

#include "contact/contact_points.hpp"

/// Normal cones of features: the directions in which a body ends there.
namespace talus {

/// The least rise of the edges at a node against `normal` (sine). Not below 0: the opposite of the normal lies in the
/// node's normal cone.
double rise(const StepGeometry& step, int node, const Vec3& normal);

/// Whether a convex edge that ends at the node lies along the plane of `normal`, to within `tolerance` (sine), and the
/// opposite of the normal in the edge's cone. At a convex node that says no more than its own cone; where a rim ends in
/// a concave corner, as that of a square hole does, the rim's edges bear though the corner as a whole cannot.
bool an_edge_lies_along(const StepGeometry& step, int node, const Vec3& normal, double tolerance);

/// Both facets of an edge: unit vectors in each, square to the edge, away from it. A direction against which neither
/// rises lies in the edge's normal cone.
std::array<Vec3, 2> into_facets(const StepGeometry& step, const ContactEdge& e);

}  // namespace talus
