#include "contact/narrow/normal_cones.hpp"

#include <algorithm>
#include <cmath>

namespace talus {

double rise(const StepGeometry& step, int node, const Vec3& normal) {
  double least = 1;
  for (int q : step.features.ring(node)) {
    const Vec3 along = step.x[q] - step.x[node];
    const double length = along.norm();
    if (length > 0) least = std::min(least, along.dot(normal) / length);
  }
  return least;
}

bool is_in_cone(const StepGeometry& step, int node, const Vec3& normal) {
  const auto ring = step.features.ring(node);
  return std::none_of(ring.begin(), ring.end(), [&](int q) {
    const Vec3 along = step.x[q] - step.x[node];
    const double rises = along.dot(normal);
    return rises < 0 && rises / along.norm() < -step.cone_tolerance;
  });
}

bool is_in_cone(const StepGeometry& step, const FeatureShapes::Edge& edge, const Vec3& inwards) {
  return edge.into[0].dot(inwards) >= -step.cone_tolerance && edge.into[1].dot(inwards) >= -step.cone_tolerance;
}

bool an_edge_lies_along(const StepGeometry& step, int node, const Vec3& normal) {
  const auto numbers = step.features.edges_at(node);
  return std::any_of(numbers.begin(), numbers.end(), [&](int number) {
    if (!step.features.edges[number].is_sharp) return false;
    const FeatureShapes::Edge& edge = step.shapes.edge(number);
    return edge.is_convex && is_in_cone(step, edge, normal) && std::abs(edge.along.dot(normal)) <= step.cone_tolerance;
  });
}

}  // namespace talus
