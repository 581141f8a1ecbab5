#pragma once

#include <array>

#include "contact/contact_points.hpp"

/// Normal cones of features: the directions in which a body ends there.
namespace talus {

/// The least rise of the edges at a node against `normal` (sine). Not below 0: the opposite of the normal lies in the
/// node's normal cone.
double rise(const StepGeometry& step, int node, const Vec3& normal);

/// Both facets of an edge: unit vectors in each, square to the edge, away from it. A direction against which neither
/// rises lies in the edge's normal cone.
std::array<Vec3, 2> into_facets(const StepGeometry& step, const ContactEdge& e);

}  // namespace talus
