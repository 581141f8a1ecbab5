#include "contact/narrow/false_vertices.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/parallel.hpp"
#include "base/units.hpp"
#include "contact/narrow/normal_cones.hpp"

namespace talus {
namespace {

/// Of a point with a vertex: the face of the other body.
int face_below(const StepGeometry& step, const FoundPoint& p) {
  const int own = step.features.body_of(p.node);
  return step.features.facets[p.facets[p.bodies[0] == own ? 1 : 0]].face;
}

/// Calls `visit` with the normals of the facets across those convex sharp edges of `face` that its point `p` is nearer
/// to than `near` [m], and how far it is from them [m].
template <class Visit>
void visit_across_sharp_edges(const StepGeometry& step, int face, const Vec3& p, double near, const Visit& visit) {
  const ContactFeatures& features = step.features;
  const auto visit_if_convex = [&](int across, const Vec3& on_edge, double distance) {
    if (!(distance < near) || features.facets[across].smooth_face == features.faces[face].smooth_face) return;
    const Vec3 &n = step.normal(across), inwards = step.centre(face) - on_edge;
    if (n.dot(inwards) < -step.cone_tolerance() * inwards.norm()) visit(n, distance);
  };
  for (const int edge : features.sides(face)) {
    const ContactEdge& e = features.edges[edge];
    const Vec3 from = step.x[e.nodes[0]], along = (step.x[e.nodes[1]] - from).stableNormalized(), r = p - from;
    visit_if_convex(features.across(edge, face), from, (r - along * along.dot(r)).norm());
  }
  for (const int node : features.outline(face)) {
    const double from_node = (p - step.x[node]).norm();
    if (!(from_node < near)) continue;
    for (const int other : features.facets_at(node)) visit_if_convex(other, step.x[node], from_node);
  }
}

constexpr int vertices_worth_a_thread = 256;

}  // namespace

void FalseVertices::add(const StepGeometry& step, FoundPoints& found) {
  for (FoundPoint& p : found.points) {
    if (p.node < 0) continue;
    const bool first = p.bodies[0] == step.features.body_of(p.node);
    held_.push_back({p.node, p.bodies[first ? 1 : 0], &p, first ? p.normal : Vec3(-p.normal)});
  }
  for (const FoundPoints::Covered& c : found.covered)
    held_.push_back({c.node, step.features.facets[c.facet].body, nullptr, c.normal});
}

void FalseVertices::drop(const StepGeometry& step) {
  const auto by_node = [](const Held& p, const Held& q) { return p.node < q.node; };
  std::sort(held_.begin(), held_.end(), by_node);
  const auto drop_false = [&](int first, int last) {
    for (int i = first; i < last; ++i)
      if (i == 0 || held_[i - 1].node != held_[i].node) drop_false_at(step, i);
  };
  in_parallel(static_cast<int>(held_.size()), vertices_worth_a_thread, std::ref(drop_false));
  drop_doubled(step);
}

/// All that holds the node of number `begin`.
void FalseVertices::drop_false_at(const StepGeometry& step, int begin) {
  const auto same = [&](const Held& h) { return h.node == held_[begin].node; };
  const auto end = std::find_if_not(held_.begin() + begin, held_.end(), same);
  const std::span<const Held> group(held_.begin() + begin, end);
  for (const Held& h : group) {
    if (!h.point || h.point->kind != PointKind::vertex_face) continue;
    h.point->dropped = past_sharp_edge(step, h, group) || deeper(step, h, group);
  }
}

/// Within the edge tolerance of a convex sharp edge a vertex is past it where something flush with the facet across
/// holds it: else a corner that rests on one slab would catch on the side of the next. Where all its edges lie past the
/// sharp edge it is passing, unless it points at this facet. An edge that reaches back over the facet lies on it,
/// though it ends at the sharp edge.
bool FalseVertices::past_sharp_edge(const StepGeometry& step, const Held& h, std::span<const Held> group) const {
  const FoundPoint& p = *h.point;
  const int face = face_below(step, p), own = step.features.body_of(p.node);
  const Vec3 projection = step.x[p.node] - p.gap * h.normal;
  const bool points_at_it = rise(step, p.node, h.normal) > step.cone_tolerance();
  const double flush = std::cos(radians(step.tolerances.flush_angle));
  bool drop = false;
  visit_across_sharp_edges(
      step, face, projection, step.largest_edge_tolerance(h.body, own), [&](const Vec3& across, double distance) {
        const bool passes = !points_at_it && rise(step, p.node, across) >= -step.cone_tolerance();
        if (passes && step.within_edge_tolerance(distance, h.body, own, across)) drop = true;
        if (!(distance < step.edge_tolerance(h.body, own))) return;
        for (const Held& other : group) {
          const bool holds = other.body != h.body && (!other.point || other.point->gap <= step.reach);
          if (holds && other.normal.dot(across) > flush) drop = true;
        }
      });
  return drop;
}

/// Of two facets of one body that form a convex edge, a vertex that is inside both has come through the nearer one; one
/// at which only edges touch may have an edge on each.
bool FalseVertices::deeper(const StepGeometry& step, const Held& h, std::span<const Held> group) const {
  const FoundPoint& p = *h.point;
  if (!(p.gap < 0) || rise(step, p.node, h.normal) < -step.cone_tolerance()) return false;
  const int face = face_below(step, p);
  for (const Held& other : group) {
    if (!other.point || other.point == h.point || other.body != h.body) continue;
    const FoundPoint& q = *other.point;
    if (!(q.gap < 0)) continue;
    const int neighbour = face_below(step, q);
    const Vec3 across = step.centre(face) - step.centre(neighbour);
    const bool convex = other.normal.dot(across) < 0 && h.normal.dot(across) > 0;
    const bool tie = p.gap == q.gap && p.key > q.key && q.kind == PointKind::vertex_face;
    if (convex && (p.gap < q.gap || tie)) return true;
  }
  return false;
}

/// Two corners in one place may each lie on a facet of the other: one contact, through the nearer facet.
void FalseVertices::drop_doubled(const StepGeometry& step) {
  const auto pushes = [&](const Held& h) {
    if (!h.point) return false;
    const FoundPoint& p = *h.point;
    return p.kind == PointKind::vertex_face && !p.dropped && p.gap < 0;
  };
  const auto stands_for = [&](const Held& other, const Held& h) {
    const FoundPoint &p = *h.point, &q = *other.point;
    const auto nodes = step.features.outline(face_below(step, q));
    return std::find(nodes.begin(), nodes.end(), h.node) != nodes.end() &&
           (q.gap != p.gap ? q.gap > p.gap : q.key < p.key);
  };
  for (const Held& h : held_) {
    if (!pushes(h)) continue;
    FoundPoint& p = *h.point;
    const double edge_tolerance = step.edge_tolerance(p.bodies[0], p.bodies[1]);
    for (const int corner : step.features.outline(face_below(step, p))) {
      if ((step.x[corner] - step.x[h.node]).norm() > edge_tolerance) continue;
      const auto [begin, end] = std::equal_range(held_.begin(), held_.end(), Held{corner, 0, nullptr, {}},
                                                 [](const Held& a, const Held& b) { return a.node < b.node; });
      p.dropped = p.dropped || std::any_of(begin, end, [&](const Held& q) { return pushes(q) && stands_for(q, h); });
    }
  }
}

}  // namespace talus
