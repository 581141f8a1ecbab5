#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/units.hpp"
#include "contact/cones.hpp"
#include "contact/contact_memory.hpp"
#include "contact/contact_points.hpp"
#include "contact/inside.hpp"

namespace talus {
namespace {

constexpr double past_end = 1e-9;     // of an edge, so that nothing falls between two
constexpr double least_ridge = 2e-4;  // rad: what crosses a flatter one goes in by less than this share of the size
constexpr double same_place = 1e-3;   // of the size: two contacts there with one normal are one

/// Convex, and not so flat that it is but an edge of the mesh: most are, and this is all they cost.
bool is_ridge(const StepGeometry& step, const ContactEdge& e) {
  const Vec3 r = step.x[e.opposite[1]] - step.x[e.nodes[0]], u = step.x[e.nodes[1]] - step.x[e.nodes[0]];
  const double below = step.normals[e.facets[0]].dot(r), along = r.dot(u), length = u.squaredNorm();
  return below < 0 && below * below * length > least_ridge * least_ridge * (r.squaredNorm() * length - along * along);
}

/// Is the normal that of two facets beside the edges that face each other? Then these have the contact. Either facet
/// may be within the facing angle of the normal though the two are not of each other.
bool lies_between_facing(const StepGeometry& step, const ContactEdge& a, const ContactEdge& b, const Vec3& n) {
  const double facing = std::cos(radians(step.settings.facing_angle));
  for (const int f : a.facets) {
    const Vec3 of_a = step.fresh_normal(f);
    if (!(-n.dot(of_a) > facing)) continue;
    for (const int g : b.facets) {
      const Vec3 of_b = step.fresh_normal(g);
      if (n.dot(of_b) > facing && of_a.dot(of_b) < -facing) return true;
    }
  }
  return false;
}

/// Whether an edge cuts through the body of a ridge, which it crosses at `share`, `depth` behind it: it is inside as
/// far to one side of there as it is deep; or the middle of what lies behind both flanks is, or, beside a corner, that
/// of what lies behind the facets there, too.
bool cuts_through(const StepGeometry& step, const ContactEdge& e, const ContactEdge& ridge, double share,
                  double depth) {
  const Vec3 &from = step.x[e.nodes[0]], along = step.x[e.nodes[1]] - from;
  const int body = step.features.facets[ridge.facets[0]].body;
  const auto is_inside = [&](double at) { return lies_inside(step, body, from + at * along); };
  const double aside = depth / along.norm();
  if (is_inside(share - aside) || is_inside(share + aside)) return true;
  double begin = 0, end = 1;
  const auto cut_by = [&](int facet, int node) {
    const Vec3 n = step.fresh_normal(facet);
    const double height = n.dot(from - step.x[node]), rise = n.dot(along);
    if (rise > 0) end = std::min(end, -height / rise);
    if (rise < 0) begin = std::max(begin, -height / rise);
    if (rise == 0 && height > 0) end = begin;
  };
  const auto middle_is_inside = [&] { return begin < end && is_inside((begin + end) / 2); };
  for (const int f : ridge.facets) cut_by(f, ridge.nodes[0]);
  if (middle_is_inside()) return true;
  for (const int node : ridge.nodes)
    for (const int f : step.features.facets_at(node)) cut_by(f, node);
  return middle_is_inside();
}

/// What crosses an edge of the mesh nearer to the crease that it ends at than `near` came past that crease.
bool crease_has_it(const StepGeometry& step, const ContactEdge& e, double from_first, double from_second, double near) {
  const int patch = step.features.facets[e.facets[0]].patch;
  const auto on_crease = [&](int node) {
    const auto facets = step.features.facets_at(node);
    return std::any_of(facets.begin(), facets.end(), [&](int f) { return step.features.facets[f].patch != patch; });
  };
  return !e.parts && ((from_first < near && on_crease(e.nodes[0])) || (from_second < near && on_crease(e.nodes[1])));
}

}  // namespace

void EdgeSearch::find(const StepGeometry& step, std::span<const FacetPair> pairs, const VertexSearch& vertices,
                      FoundPoints& found) {
  const auto ridge = [&](const ContactFacet& facet, int k) {
    return facet.owns_edge[k] && is_ridge(step, step.features.edges[facet.edges[k]]);
  };
  for (const FacetPair& pair : pairs) {
    const ContactFacet &a = step.features.facets[pair.a], &b = step.features.facets[pair.b];
    const std::array<bool, 3> of_b = {ridge(b, 0), ridge(b, 1), ridge(b, 2)};
    if (!of_b[0] && !of_b[1] && !of_b[2]) continue;
    for (int i = 0; i < 3; ++i) {
      if (!ridge(a, i)) continue;
      for (int j = 0; j < 3; ++j) {
        if (of_b[j]) cross(step, a.edges[i], b.edges[j], vertices, found);
      }
    }
  }
}

void EdgeSearch::cross(const StepGeometry& step, int edge_a, int edge_b, const VertexSearch& vertices,
                       FoundPoints& found) {
  const ContactEdge &a = step.features.edges[edge_a], &b = step.features.edges[edge_b];
  const Vec3 &a0 = step.x[a.nodes[0]], &b0 = step.x[b.nodes[0]];
  const Vec3 u = step.x[a.nodes[1]] - a0, w = step.x[b.nodes[1]] - b0, c = u.cross(w), r = b0 - a0;
  const double squared = c.squaredNorm();
  if (!(squared > nearly_parallel * u.squaredNorm() * w.squaredNorm())) return;
  const double s = r.cross(w).dot(c) / squared, t = r.cross(u).dot(c) / squared;
  if (!(s >= -past_end && s <= 1 + past_end && t >= -past_end && t <= 1 + past_end)) return;

  const ContactFacet &fa = step.features.facets[a.facets[0]], &fb = step.features.facets[b.facets[0]];
  const double size = step.broad.scale(fa.body, fb.body).size, la = u.norm(), lb = w.norm();
  Vec3 n = c / std::sqrt(squared);
  const auto into_a = into_facets(step, a), into_b = into_facets(step, b);
  const double tolerance = cone_tolerance(step.settings);
  const auto in_both_cones = [&](const Vec3& m) {
    return m.dot(into_a[0]) >= -tolerance && m.dot(into_a[1]) >= -tolerance && m.dot(into_b[0]) <= tolerance &&
           m.dot(into_b[1]) <= tolerance;
  };
  if (!in_both_cones(n)) {
    n = -n;
    if (!in_both_cones(n)) return;
  }
  const double gap = -n.dot(r);
  if (!(gap <= step.reach) || (gap < 0 && gap < -step.depth(fa.body, fb.body))) return;
  // Edges may cross beside the bodies, and still far behind each other along the normal: near a ridge's end, or where
  // both are sharp. What has come in is inside.
  const std::uint64_t key = edge_key(edge_a, edge_b);
  const bool is_late = -gap > step.rim(fa.body, fb.body) && step.begun(fa.body, fb.body) && !step.memory.remembers(key);
  if (is_late && !(cuts_through(step, a, b, s, -gap) && cuts_through(step, b, a, t, -gap))) return;
  // An end near the other edge has the contact if it ends its body in this direction and was found there: so near that
  // both are in one place, or nearer than the edge seems deep, for then it came past that one.
  const double near = std::max(step.rim(fa.body, fb.body), -gap);
  const auto end_has_it = [&](int node, double away, const Vec3& inwards, const ContactEdge& other) {
    if (away > near || !step.features.corner[node] || rise(step, node, inwards) < -tolerance) return false;
    return std::any_of(other.facets.begin(), other.facets.end(),
                       [&](int f) { return vertices.has(node, step.features.facets[f].patch); });
  };
  if (end_has_it(a.nodes[0], s * la, n, b) || end_has_it(a.nodes[1], (1 - s) * la, n, b)) return;
  if (end_has_it(b.nodes[0], t * lb, -n, a) || end_has_it(b.nodes[1], (1 - t) * lb, -n, a)) return;
  if (crease_has_it(step, a, s * la, (1 - s) * la, near) || crease_has_it(step, b, t * lb, (1 - t) * lb, near)) return;
  if (lies_between_facing(step, a, b, n)) return;

  FoundPoint p{};
  p.key = key;
  p.kind = PointKind::edge;
  p.family = crease_family(a.crease, b.crease);
  p.facets = {a.facets[0], b.facets[0]};
  p.patches = {-1, -1};
  p.node = -1;
  p.joint = -1;
  for (int f : a.facets) {
    for (int g : b.facets) p.joint = std::max(p.joint, step.common_joint(f, g));
  }
  p.normal = n;
  p.position = a0 + s * u;
  if (found_before(p, std::min({s * la, (1 - s) * la, t * lb, (1 - t) * lb}), same_place * size, step, found)) return;
  found.add_between(p, a.nodes, s, b.nodes, t, step.features, step.x);
}

/// At the end of an edge the next edge, or a vertex, may have found the same contact.
bool EdgeSearch::found_before(const FoundPoint& p, double from_end, double near, const StepGeometry& step,
                              const FoundPoints& found) const {
  if (from_end > near) return false;
  const auto body = [&](const FoundPoint& q, int k) { return step.features.facets[q.facets[k]].body; };
  const double same_normal = std::cos(radians(step.settings.facing_angle));
  for (const FoundPoint& q : found.points) {
    if (q.dropped || q.kind == PointKind::facing || body(p, 0) != body(q, 0) || body(p, 1) != body(q, 1)) continue;
    if ((q.position - p.position).norm() < near && q.normal.dot(p.normal) > same_normal) return true;
  }
  return false;
}

}  // namespace talus
