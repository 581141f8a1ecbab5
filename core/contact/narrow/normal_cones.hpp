#pragma once

#include "contact/narrow/step_geometry.hpp"

/// Normal cones of features: the directions in which a body ends there.
namespace talus {

/// The least slope of the edges at a node along `normal` (sine): if it is not below 0, the opposite of `normal` lies in
/// the node's normal cone.
double rise(const StepGeometry& step, int node, const Vec3& normal);

/// Whether it does, to within the angle by which normals may leave a cone.
bool is_in_cone(const StepGeometry& step, int node, const Vec3& normal);

/// Whether `inwards` leads into both facets of an edge, or along them, to within that angle: the opposite of it lies in
/// the edge's normal cone.
bool is_in_cone(const StepGeometry& step, const FeatureShapes::Edge& edge, const Vec3& inwards);

/// Whether a convex edge that ends at the node lies along the plane of `normal`, to within that angle, and the opposite
/// of the normal in the edge's cone. At a convex node that says no more than its own cone. In a concave
/// corner, as of a square hole, the sharp edges that end there may touch though the corner as a whole cannot.
bool an_edge_lies_along(const StepGeometry& step, int node, const Vec3& normal);

}  // namespace talus
