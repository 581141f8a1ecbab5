#include "contact/narrow/normal_cones.hpp"

#include <algorithm>
#include <cmath>

namespace talus {
namespace {

constexpr double clearly_less = 0.999;  // – than another one, whatever rounding did to both

}  // namespace

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
    if (!(rises < 0)) return false;
    const double squared = rises * rises, most = step.cone_tolerance * step.cone_tolerance * along.squaredNorm();
    if (squared < clearly_less * most || clearly_less * squared > most) return squared > most;
    return rises / along.norm() < -step.cone_tolerance;
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
