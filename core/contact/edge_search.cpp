#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

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

/// Where two edges cross, seen along a normal into whose cones both bodies' facets let them.
struct Crossing {
  const ContactEdge &a, &b;
  double s = 0, t = 0;                                             // shares of the way along a and b
  std::array<double, 2> from_ends_of_a = {}, from_ends_of_b = {};  // m
  Vec3 normal = Vec3::Zero();                                      // from b's body to a's
  Vec3 position = Vec3::Zero();                                    // on a
  double gap = 0;                                                  // m
};

std::optional<Crossing> crossing_of(const StepGeometry& step, const ContactEdge& a, const ContactEdge& b) {
  const Vec3 &a0 = step.x[a.nodes[0]], &b0 = step.x[b.nodes[0]];
  const Vec3 u = step.x[a.nodes[1]] - a0, w = step.x[b.nodes[1]] - b0, c = u.cross(w), r = b0 - a0;
  const double squared = c.squaredNorm();
  if (!(squared > nearly_parallel * u.squaredNorm() * w.squaredNorm())) return {};
  const double s = r.cross(w).dot(c) / squared, t = r.cross(u).dot(c) / squared;
  if (!(s >= -past_end && s <= 1 + past_end && t >= -past_end && t <= 1 + past_end)) return {};

  const auto into_a = into_facets(step, a), into_b = into_facets(step, b);
  const double tolerance = cone_tolerance(step.settings);
  const auto in_both_cones = [&](const Vec3& m) {
    return m.dot(into_a[0]) >= -tolerance && m.dot(into_a[1]) >= -tolerance && m.dot(into_b[0]) <= tolerance &&
           m.dot(into_b[1]) <= tolerance;
  };
  Vec3 n = c / std::sqrt(squared);
  if (!in_both_cones(n)) {
    n = -n;
    if (!in_both_cones(n)) return {};
  }
  const double la = u.norm(), lb = w.norm();
  return Crossing{a, b, s, t, {s * la, (1 - s) * la}, {t * lb, (1 - t) * lb}, n, a0 + s * u, -n.dot(r)};
}

/// Edges may cross beside the bodies, and still far behind each other along the normal: near a ridge's end, or where
/// both are sharp. What has come in is inside.
bool passes_beside(const StepGeometry& step, const Crossing& c) {
  return !(cuts_through(step, c.a, c.b, c.s, -c.gap) && cuts_through(step, c.b, c.a, c.t, -c.gap));
}

/// An end nearer to the other edge than `near` has the contact if it ends its body in this direction and was found
/// there.
bool end_has_it(const StepGeometry& step, const VertexSearch& vertices, const ContactEdge& e,
                const std::array<double, 2>& from_ends, const Vec3& inwards, const ContactEdge& other, double near) {
  const auto has_it = [&](int node) {
    if (!step.features.corner[node] || rise(step, node, inwards) < -cone_tolerance(step.settings)) return false;
    return std::any_of(other.facets.begin(), other.facets.end(),
                       [&](int f) { return vertices.has(node, step.features.facets[f].patch); });
  };
  return (from_ends[0] <= near && has_it(e.nodes[0])) || (from_ends[1] <= near && has_it(e.nodes[1]));
}

/// What crosses an edge of the mesh nearer to the crease that it ends at than `near` came past that crease.
bool crease_has_it(const StepGeometry& step, const ContactEdge& e, const std::array<double, 2>& from_ends,
                   double near) {
  const int patch = step.features.facets[e.facets[0]].patch;
  const auto on_crease = [&](int node) {
    const auto facets = step.features.facets_at(node);
    return std::any_of(facets.begin(), facets.end(), [&](int f) { return step.features.facets[f].patch != patch; });
  };
  return !e.parts && ((from_ends[0] < near && on_crease(e.nodes[0])) || (from_ends[1] < near && on_crease(e.nodes[1])));
}

FoundPoint point_at(const StepGeometry& step, const Crossing& c, std::uint64_t key) {
  FoundPoint p{};
  p.key = key;
  p.kind = PointKind::edge;
  p.family = crease_family(c.a.crease, c.b.crease);
  p.facets = {c.a.facets[0], c.b.facets[0]};
  p.patches = {-1, -1};
  p.node = -1;
  p.joint = -1;
  for (int f : c.a.facets) {
    for (int g : c.b.facets) p.joint = std::max(p.joint, step.common_joint(f, g));
  }
  p.normal = c.normal;
  p.position = c.position;
  return p;
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
  const std::optional<Crossing> crossing = crossing_of(step, step.features.edges[edge_a], step.features.edges[edge_b]);
  if (!crossing) return;
  const Crossing& c = *crossing;
  const auto &of_a = c.from_ends_of_a, &of_b = c.from_ends_of_b;
  const int body_a = step.features.facets[c.a.facets[0]].body, body_b = step.features.facets[c.b.facets[0]].body;
  if (!(c.gap <= step.reach) || (c.gap < 0 && c.gap < -step.depth(body_a, body_b))) return;
  const std::uint64_t key = edge_key(edge_a, edge_b);
  const double rim = step.rim(body_a, body_b);
  const bool is_late = -c.gap > rim && step.begun(body_a, body_b) && !step.memory.remembers(key);
  if (is_late && passes_beside(step, c)) return;
  // An end is near where both are in one place, or nearer than the edge seems deep: then it came past that one.
  const double near = std::max(rim, -c.gap);
  if (end_has_it(step, vertices, c.a, of_a, c.normal, c.b, near)) return;
  if (end_has_it(step, vertices, c.b, of_b, -c.normal, c.a, near)) return;
  if (crease_has_it(step, c.a, of_a, near) || crease_has_it(step, c.b, of_b, near)) return;
  if (lies_between_facing(step, c.a, c.b, c.normal)) return;

  const FoundPoint p = point_at(step, c, key);
  const double size = step.broad.scale(body_a, body_b).size;
  if (found_before(p, std::min({of_a[0], of_a[1], of_b[0], of_b[1]}), same_place * size, step, found)) return;
  found.add_between(p, c.a.nodes, c.s, c.b.nodes, c.t, step.features, step.x);
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
