#include "contact/narrow/separating_axis.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace talus {
namespace {

constexpr double rounding_of_gaps = 1e-9;  // of the size: by as much two measures of one gap may differ

/// Whether it holds for any of the body's clearly convex edges.
template <class Holds>
bool any_edge(const StepGeometry& step, int body, const Holds& holds) {
  for (int f = step.features.face_begin[body]; f < step.features.face_begin[body + 1]; ++f)
    for (const int edge : step.features.owned_edges(f))
      if (step.shapes.edge(edge).is_clearly_convex && holds(edge)) return true;
  return false;
}

/// How high the lowest vertex of a body lies above a face of another, or `enough` if it lies lower than that. [m]
double lowest(const StepGeometry& step, int body, int face, double enough) {
  const Vec3 &normal = step.face_normal(face), &origin = step.x[step.features.outline(face)[0]];
  double least = std::numeric_limits<double>::infinity();
  for (int f = step.features.face_begin[body]; f < step.features.face_begin[body + 1]; ++f)
    for (const int node : step.features.owned_nodes(f)) {
      least = std::min(least, normal.dot(step.x[node] - origin));
      if (least <= enough) return enough;
    }
  return least;
}

}  // namespace

bool SeparatingAxis::refutes(const StepGeometry& step, int body_a, int body_b, double gap) {
  const double enough = gap + step.noticeable_depth(body_a, body_b);
  if (!(enough < 0) || !step.features.keeps_shape(body_a) || !step.features.keeps_shape(body_b)) return false;
  return any_wider(step, body_a, body_b, enough);
}

bool SeparatingAxis::confirms(const StepGeometry& step, int body_a, int body_b, double gap) {
  if (!step.features.was_convex(body_a) || !step.features.was_convex(body_b)) return false;
  const bool are_convex = step.features.is_convex(body_a) && step.features.is_convex(body_b);
  const double as_deep =
      are_convex ? rounding_of_gaps * step.broad.size(body_a, body_b) : step.noticeable_depth(body_a, body_b);
  return !any_wider(step, body_a, body_b, gap + as_deep);
}

bool SeparatingAxis::any_wider(const StepGeometry& step, int body_a, int body_b, double enough) {
  if (bodies_ != std::array{body_a, body_b}) {
    bodies_ = {body_a, body_b};
    widest_ = -std::numeric_limits<double>::infinity();
    complete_ = false;
  }
  if (widest_ > enough || complete_) return widest_ > enough;
  look_along_normals(step, body_a, body_b, enough);
  look_along_normals(step, body_b, body_a, enough);
  if (step.features.was_convex(body_a) && step.features.was_convex(body_b)) look_across_edges(step, enough);
  complete_ = !(widest_ > enough);
  return !complete_;
}

void SeparatingAxis::look_along_normals(const StepGeometry& step, int body, int other, double enough) {
  for (const int face : step.features.supporting_faces(body)) {
    if (widest_ > enough) return;
    widest_ = std::max(widest_, lowest(step, other, face, widest_));
  }
}

/// Of two edges whose normals are opposite somewhere no other vertex lies nearer along the direction across both.
void SeparatingAxis::look_across_edges(const StepGeometry& step, double enough) {
  if (widest_ > enough) return;
  any_edge(step, bodies_[0], [&](int edge_a) {
    const ContactEdge& a = step.features.edges[edge_a];
    const std::array<Vec3, 2>& into_a = step.shapes.edge(edge_a).into;
    const Vec3 &origin = step.x[a.nodes[0]], u = step.x[a.nodes[1]] - origin;
    return any_edge(step, bodies_[1], [&](int edge_b) {
      const ContactEdge& b = step.features.edges[edge_b];
      const std::array<Vec3, 2>& into_b = step.shapes.edge(edge_b).into;
      const Vec3 w = step.x[b.nodes[1]] - step.x[b.nodes[0]];
      Vec3 across = u.cross(w);
      if (across.dot(into_a[0]) < 0) across = -across;
      if (across.dot(into_a[1]) < 0 || across.dot(into_b[0]) > 0 || across.dot(into_b[1]) > 0) return false;
      const double squared = across.squaredNorm();
      if (!(squared > step.tolerances.parallel_edges * u.squaredNorm() * w.squaredNorm())) return false;
      widest_ = std::max(widest_, across.dot(origin - step.x[b.nodes[0]]) / std::sqrt(squared));
      return widest_ > enough;
    });
  });
}

}  // namespace talus
