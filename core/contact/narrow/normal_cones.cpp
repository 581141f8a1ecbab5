#include "contact/narrow/normal_cones.hpp"

#include <Eigen/Geometry>
#include <algorithm>

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

bool an_edge_lies_along(const StepGeometry& step, int node, const Vec3& normal, double tolerance) {
  for (const int number : step.features.edges_at(node)) {
    const ContactEdge& e = step.features.edges[number];
    if (!e.is_sharp) continue;
    const Vec3 along = (step.x[e.nodes[1]] - step.x[e.nodes[0]]).stableNormalized();
    if (std::abs(along.dot(normal)) > tolerance) continue;
    const FeatureShapes::Edge& edge = step.shapes.edge(number);
    if (edge.is_convex && edge.into[0].dot(normal) >= -tolerance && edge.into[1].dot(normal) >= -tolerance) return true;
  }
  return false;
}

}  // namespace talus
