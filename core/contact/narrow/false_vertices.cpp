#include "contact/narrow/false_vertices.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/parallel.hpp"
#include "contact/narrow/normal_cones.hpp"
#include "contact/narrow/separating_axis.hpp"

namespace talus {
namespace {

/// Of a point with a vertex: the face of the other body.
int face_below(const StepGeometry& step, const FoundPoint& p) {
  const int own = step.features.body_of(p.node);
  return step.features.facets[p.facets[p.bodies[0] == own ? 1 : 0]].face;
}

/// Whether it holds for the normal of a facet across one of those convex sharp edges of `face` that its point `p` is
/// nearer to than `near` [m], and how far it is from the edge [m].
template <class Holds>
bool any_across_sharp_edges(const StepGeometry& step, int face, const Vec3& p, double near, const Holds& holds) {
  const ContactFeatures& features = step.features;
  const Vec3 centre = step.centre(face);
  const auto convex_and_holds = [&](int across, const Vec3& on_edge, double distance) {
    if (!(distance < near) || features.facets[across].smooth_face == features.faces[face].smooth_face) return false;
    const Vec3 &n = step.normal(across), inwards = centre - on_edge;
    return n.dot(inwards) < -step.cone_tolerance * inwards.norm() && holds(n, distance);
  };
  for (const int edge : features.sides(face)) {
    const Vec3 &from = step.x[features.edges[edge].nodes[0]], &along = step.shapes.edge(edge).along, r = p - from;
    const double squared = (r - along * along.dot(r)).squaredNorm();
    if (squared > 2 * near * near) continue;  // clearly
    if (convex_and_holds(features.across(edge, face), from, std::sqrt(squared))) return true;
  }
  for (const int node : features.outline(face)) {
    const double squared = (p - step.x[node]).squaredNorm();
    if (squared > 2 * near * near) continue;  // clearly
    const double from_node = std::sqrt(squared);
    if (!(from_node < near)) continue;
    for (const int other : features.facets_at(node))
      if (convex_and_holds(other, step.x[node], from_node)) return true;
  }
  return false;
}

constexpr int vertices_worth_a_thread = 256;

}  // namespace

void FalseVertices::add(const StepGeometry& step, FoundPoints& found) {
  for (FoundPoint& p : found.points) {
    if (p.node < 0) continue;
    const bool first = p.bodies[0] == step.features.body_of(p.node);
    held_.add(p.node, {p.node, p.bodies[first ? 1 : 0], &p, first ? p.normal : Vec3(-p.normal)});
  }
  for (const FoundPoints::Covered& c : found.covered)
    held_.add(c.node, {c.node, step.features.facets[c.facet].body, nullptr, c.normal});
}

void FalseVertices::drop(const StepGeometry& step) {
  const auto drop_false = [&](int first, int last) {
    for (int i = first; i < last; ++i) {
      const Held& h = held_[i];
      if (!h.point || h.point->kind != PointKind::vertex_face) continue;
      h.point->dropped = past_sharp_edge(step, h) || deeper(step, h);
    }
  };
  in_parallel(held_.size(), vertices_worth_a_thread, std::ref(drop_false));
  drop_doubled(step);
}

/// Within the edge tolerance of a convex sharp edge a vertex is past it where something flush with the facet across
/// holds it: else a corner that rests on one slab would catch on the side of the next. Where all its edges lie past the
/// sharp edge it is passing, unless it points at this facet. An edge that reaches back over the facet lies on it,
/// though it ends at the sharp edge.
bool FalseVertices::past_sharp_edge(const StepGeometry& step, const Held& h) const {
  const FoundPoint& p = *h.point;
  const int face = face_below(step, p), own = step.features.body_of(p.node);
  const Vec3 projection = step.x[p.node] - p.gap * h.normal;
  const auto points_at_it = [&] { return rise(step, p.node, h.normal) > step.cone_tolerance; };
  const auto is_past = [&](const Vec3& across, double distance) {
    const bool passes = is_in_cone(step, p.node, across) && !points_at_it();
    if (passes && step.within_edge_tolerance(distance, h.body, own, across)) return true;
    if (!(distance < step.edge_tolerance(h.body, own))) return false;
    return held_.any_of(h.node, [&](const Held& other) {
      const bool holds = other.body != h.body && (!other.point || other.point->gap <= step.reach(own, other.body));
      return holds && other.normal.dot(across) > step.flush_cosine;
    });
  };
  return any_across_sharp_edges(step, face, projection, step.largest_edge_tolerance(h.body, own), is_past);
}

/// Of two facets of one body that form a convex edge, a vertex that is inside both has come through the nearer one,
/// unless the bodies are less deep in each other in no other direction than through the farther; one at which only
/// edges touch may have an edge on each.
bool FalseVertices::deeper(const StepGeometry& step, const Held& h) const {
  const FoundPoint& p = *h.point;
  if (!(p.gap < 0) || !is_in_cone(step, p.node, h.normal)) return false;
  const int face = face_below(step, p);
  const bool nearer = held_.any_of(h.node, [&](const Held& other) {
    if (!other.point || other.point == h.point || other.body != h.body) return false;
    const FoundPoint& q = *other.point;
    if (!(q.gap < 0)) return false;
    const int neighbour = face_below(step, q);
    const Vec3 across = step.centre(face) - step.centre(neighbour);
    const bool convex = other.normal.dot(across) < 0 && h.normal.dot(across) > 0;
    const bool tie = p.gap == q.gap && p.key > q.key && q.kind == PointKind::vertex_face;
    return convex && (p.gap < q.gap || tie);
  });
  return nearer && !SeparatingAxis().confirms(step, p.bodies[0], p.bodies[1], p.gap);
}

bool FalseVertices::pushes(const Held& held) {
  return held.point && held.point->kind == PointKind::vertex_face && !held.point->dropped && held.point->gap < 0;
}

/// Two corners in one place may each lie on a facet of the other: one contact, through the nearer facet.
void FalseVertices::drop_doubled(const StepGeometry& step) {
  pushing_.clear();
  for (int i = 0; i < held_.size(); ++i)
    if (pushes(held_[i])) pushing_.push_back(held_[i]);
  std::sort(pushing_.begin(), pushing_.end(), [](const Held& a, const Held& b) { return a.node < b.node; });
  const auto stands_for = [&](const Held& other, const Held& h) {
    const FoundPoint &p = *h.point, &q = *other.point;
    const auto nodes = step.features.outline(face_below(step, q));
    return std::find(nodes.begin(), nodes.end(), h.node) != nodes.end() &&
           (q.gap != p.gap ? q.gap > p.gap : q.key < p.key);
  };
  for (const Held& h : pushing_) {
    if (!pushes(h)) continue;
    FoundPoint& p = *h.point;
    const double edge_tolerance = step.edge_tolerance(p.bodies[0], p.bodies[1]);
    for (const int corner : step.features.outline(face_below(step, p))) {
      if ((step.x[corner] - step.x[h.node]).norm() > edge_tolerance) continue;
      p.dropped = p.dropped || held_.any_of(corner, [&](const Held& q) { return pushes(q) && stands_for(q, h); });
    }
  }
}

}  // namespace talus
