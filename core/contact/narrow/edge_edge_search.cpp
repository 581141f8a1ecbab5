#include "contact/narrow/edge_edge_search.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "contact/history/contact_memory.hpp"
#include "contact/narrow/inside.hpp"
#include "contact/narrow/normal_cones.hpp"
#include "contact/narrow/valley.hpp"
#include "contact/narrow/vertex_face_search.hpp"

namespace talus {
namespace {

/// Is the normal that of two facets beside the edges in face–face contact? Then these have the contact. Both facets may
/// be within the face–face angle of the normal though they are not of each other.
bool lies_between_faces(const StepGeometry& step, const ContactEdge& a, const ContactEdge& b, const Vec3& n) {
  const double least_cosine = step.face_face_cosine;
  for (const int f : a.facets) {
    const Vec3& of_a = step.normal(f);
    if (!(-n.dot(of_a) > least_cosine)) continue;
    for (const int g : b.facets) {
      const Vec3& of_b = step.normal(g);
      if (n.dot(of_b) > least_cosine && of_a.dot(of_b) < -least_cosine) return true;
    }
  }
  return false;
}

/// Of what a point seems to be deep it is to be inside by so much at least, along the normal and against it: faces in
/// contact overlap a little, too, whichever way they look.
constexpr double least_depth_inside = 0.1;

/// Whether the edge e, which crosses a convex edge of another body at the fraction `at` of its length and `depth` [m]
/// behind it, against `outwards` (unit), cuts through that body. It does if a point of e is well inside it: as far to
/// either side of the crossing as that is deep; or in the middle of the part of e that lies behind both faces adjacent
/// to the convex edge; or of the part that lies behind all facets at the ends of the convex edge.
bool cuts_through(const StepGeometry& step, const ContactEdge& e, const ContactEdge& convex_edge, double at,
                  double depth, const Vec3& outwards) {
  const Vec3 &from = step.x[e.nodes[0]], along = step.x[e.nodes[1]] - from;
  const int body = step.features.facets[convex_edge.facets[0]].body;
  const Vec3 margin = least_depth_inside * depth * outwards;
  const auto is_inside = [&](double fraction) {
    const Vec3 point = from + fraction * along;
    return lies_inside(step, body, point + margin) && lies_inside(step, body, point - margin);
  };
  const double aside = depth / along.norm();
  if (is_inside(at - aside) || is_inside(at + aside)) return true;
  double begin = 0, end = 1;
  const auto cut_by = [&](int facet, int node) {
    const Vec3& n = step.normal(facet);
    const double height = n.dot(from - step.x[node]), rise = n.dot(along);
    if (rise > 0) end = std::min(end, -height / rise);
    if (rise < 0) begin = std::max(begin, -height / rise);
    if (rise == 0 && height > 0) end = begin;
  };
  const auto middle_is_inside = [&] { return begin < end && is_inside((begin + end) / 2); };
  for (const int f : convex_edge.facets) cut_by(f, convex_edge.nodes[0]);
  if (middle_is_inside()) return true;
  for (const int node : convex_edge.nodes)
    for (const int f : step.features.facets_at(node)) cut_by(f, node);
  return middle_is_inside();
}

/// Where two edges cross, seen along a normal into whose cones both bodies' facets let them.
struct Crossing {
  const ContactEdge &a, &b;
  double s = 0, t = 0;                                             // fractions along a and b
  std::array<double, 2> from_ends_of_a = {}, from_ends_of_b = {};  // m
  Vec3 normal = Vec3::Zero();                                      // from b's body to a's
  Vec3 position = Vec3::Zero();                                    // on a
  double gap = 0;                                                  // m
};

/// How far past one of its ends [fraction of its length] an edge holds an edge along `other`, all the same, that
/// crosses it `depth` [m] behind: where its body comes out again, `outwards`, as at the end of a valley. What runs into
/// the corner there is past the ends of both edges that meet in it (as past both faces of a valley, `held_place`).
double reach_past_end(const StepGeometry& step, const ContactEdge& edge, int end, const Vec3& other,
                      const Vec3& outwards, double depth) {
  const Vec3& corner = step.x[edge.nodes[end]];
  const auto seen_along_other = [&](int node) -> Vec3 {
    const Vec3 away = step.x[node] - corner;
    return away - away.dot(other) / other.squaredNorm() * other;
  };
  const Vec3 back = seen_along_other(edge.nodes[1 - end]);
  double reach = 0;
  for (const int node : step.features.ring(edge.nodes[end])) {
    const Vec3 out = seen_along_other(node);
    if (!(out.dot(outwards) > step.cone_tolerance * out.norm())) continue;
    const double cosine = back.dot(out) / (back.norm() * out.norm());
    reach = std::max(reach, reach_past_valley(cosine, depth));
  }
  return reach / back.norm();
}

/// Whether the fraction `at` of its length is on an edge of the body, or so little past its end that it is held there.
bool is_on_edge(const StepGeometry& step, const ContactEdge& edge, double at, const Vec3& other, const Vec3& outwards,
                double gap) {
  const double past = std::max(-at, at - 1);
  if (past <= step.tolerances.past_edge_end) return true;
  if (!(gap < 0) || step.features.is_convex(step.features.body_of(edge.nodes[0]))) return false;
  return past <= reach_past_end(step, edge, at < 0 ? 0 : 1, other, outwards, -gap);
}

std::optional<Crossing> crossing_of(const StepGeometry& step, int edge_a, int edge_b) {
  const ContactEdge &a = step.features.edges[edge_a], &b = step.features.edges[edge_b];
  const Vec3 &a0 = step.x[a.nodes[0]], &b0 = step.x[b.nodes[0]];
  const Vec3 u = step.x[a.nodes[1]] - a0, w = step.x[b.nodes[1]] - b0, c = u.cross(w), r = b0 - a0;
  const double squared = c.squaredNorm();
  const FeatureShapes::Edge &shape_a = step.shapes.edge(edge_a), &shape_b = step.shapes.edge(edge_b);
  const auto in_both_cones = [&](const Vec3& m) {
    return is_in_cone(step, shape_a, m) && is_in_cone(step, shape_b, -m);
  };
  Vec3 n = c / std::sqrt(squared);
  if (!in_both_cones(n)) {
    n = -n;
    if (!in_both_cones(n)) return {};
  }
  double s = r.cross(w).dot(c) / squared, t = r.cross(u).dot(c) / squared;
  const double gap = -n.dot(r);
  if (!is_on_edge(step, a, s, w, -n, gap) || !is_on_edge(step, b, t, u, n, gap)) return {};
  s = std::clamp(s, 0.0, 1.0);
  t = std::clamp(t, 0.0, 1.0);
  const double la = u.norm(), lb = w.norm();
  return Crossing{a, b, s, t, {s * la, (1 - s) * la}, {t * lb, (1 - t) * lb}, n, a0 + s * u, gap};
}

/// Edges may cross beside the bodies, and still far behind each other along the normal: near the end of a convex edge,
/// or where both are acute. What has come in is inside.
bool passes_beside(const StepGeometry& step, const Crossing& c) {
  return !(cuts_through(step, c.a, c.b, c.s, -c.gap, c.normal) && cuts_through(step, c.b, c.a, c.t, -c.gap, -c.normal));
}

/// An end nearer to the other edge than `near` has the contact if it ends its body in this direction and was found
/// there. Not of convex bodies, which are as deep in each other as the edges say, on a face that looks away from the
/// edges' normal, as the far face of an acute edge may: what that one holds can sink over the edge all the same.
bool end_has_it(const StepGeometry& step, const VertexFaceSearch& vertices, const ContactEdge& e,
                const std::array<double, 2>& from_ends, const Vec3& inwards, const ContactEdge& other, double near,
                bool are_convex) {
  const auto holds = [&](int node, int facet) {
    const bool looks_away = are_convex && step.normal(facet).dot(inwards) < -step.cone_tolerance;
    return !looks_away && vertices.has(node, step.features.facets[facet].smooth_face);
  };
  const auto has_it = [&](int node) {
    return step.features.corner[node] && is_in_cone(step, node, inwards) &&
           std::ranges::any_of(other.facets, [&](int facet) { return holds(node, facet); });
  };
  return (from_ends[0] <= near && has_it(e.nodes[0])) || (from_ends[1] <= near && has_it(e.nodes[1]));
}

/// What crosses an edge of the mesh nearer than `near` to the sharp edge that it ends at came past that one.
bool sharp_edge_has_it(const StepGeometry& step, const ContactEdge& e, const std::array<double, 2>& from_ends,
                       double near) {
  const int smooth_face = step.features.facets[e.facets[0]].smooth_face;
  const auto on_edge = [&](int node) {
    const auto facets = step.features.facets_at(node);
    return std::any_of(facets.begin(), facets.end(),
                       [&](int f) { return step.features.facets[f].smooth_face != smooth_face; });
  };
  return !e.is_sharp && ((from_ends[0] < near && on_edge(e.nodes[0])) || (from_ends[1] < near && on_edge(e.nodes[1])));
}

FoundPoint point_at(const StepGeometry& step, const Crossing& c, std::uint64_t key) {
  FoundPoint p{};
  p.key = key;
  p.kind = PointKind::edge_edge;
  p.family = sharp_edge_family(c.a.sharp_edge, c.b.sharp_edge);
  p.facets = {c.a.facets[0], c.b.facets[0]};
  p.smooth_faces = {-1, -1};
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

void EdgeEdgeSearch::find(const StepGeometry& step, const NearFeatures& near, const VertexFaceSearch& vertices,
                          SeparatingAxis& axis, FoundPoints& found) {
  vertices_.sort(found.points, [](const FoundPoint& p) { return p.kind != PointKind::face_face; });
  near.visit_bodies([&](const NearFeatures::OfBodies& of_bodies) {
    first_ = found.points.size();
    for (const NearFeatures::EdgeAtEdge& edges : of_bodies.crossing)
      cross(step, edges, of_bodies.depth, vertices, axis, found);
  });
}

/// `depth`: how deep the two bodies can lie in each other. [m]
void EdgeEdgeSearch::cross(const StepGeometry& step, const NearFeatures::EdgeAtEdge& near_edges, double depth,
                           const VertexFaceSearch& vertices, SeparatingAxis& axis, FoundPoints& found) {
  const auto& [edge_a, edge_b] = near_edges;
  const std::optional<Crossing> crossing = crossing_of(step, edge_a, edge_b);
  if (!crossing) return;
  const Crossing& c = *crossing;
  const auto &of_a = c.from_ends_of_a, &of_b = c.from_ends_of_b;
  const int body_a = step.features.facets[c.a.facets[0]].body, body_b = step.features.facets[c.b.facets[0]].body;
  if (!(c.gap <= step.reach(body_a, body_b)) || (c.gap < 0 && c.gap < -depth)) return;
  if (lies_between_faces(step, c.a, c.b, c.normal)) return;
  const std::uint64_t key = edge_key(edge_a, edge_b);
  const double edge_tolerance = step.edge_tolerance(body_a, body_b);
  const bool appears_deep = -c.gap > edge_tolerance && !step.memory.remembers(key);
  const bool are_convex = step.features.is_convex(body_a) && step.features.is_convex(body_b);
  if (axis.refutes(step, body_a, body_b, c.gap) || (!are_convex && appears_deep && passes_beside(step, c))) return;
  // An end is near where both are in one place, or nearer than the edge seems deep: then it came past that one.
  const double near = std::max(edge_tolerance, -c.gap);
  if (end_has_it(step, vertices, c.a, of_a, c.normal, c.b, near, are_convex)) return;
  if (end_has_it(step, vertices, c.b, of_b, -c.normal, c.a, near, are_convex)) return;
  if (sharp_edge_has_it(step, c.a, of_a, near) || sharp_edge_has_it(step, c.b, of_b, near)) return;

  FoundPoint p = point_at(step, c, key);
  p.bodies = {body_a, body_b};
  const double same_place = step.tolerances.same_place * step.broad.size(body_a, body_b);
  if (std::min({of_a[0], of_a[1], of_b[0], of_b[1]}) <= same_place && found_before(p, same_place, step, found)) return;
  found.add_between(p, c.a.nodes, c.s, c.b.nodes, c.t, step.features, step.x);
}

/// At the end of an edge the next edge, or a vertex, may have found the same contact.
bool EdgeEdgeSearch::found_before(const FoundPoint& p, double near, const StepGeometry& step,
                                  const FoundPoints& found) const {
  const double same_normal = step.face_face_cosine;
  const auto same = [&](const FoundPoint& q) {
    return !q.dropped && (q.position - p.position).norm() < near && q.normal.dot(p.normal) > same_normal;
  };
  const auto edges = std::span(found.points).subspan(first_);
  const auto vertices = vertices_.of(p.bodies);
  return std::any_of(vertices.begin(), vertices.end(), [&](const auto& q) { return same(found.points[q.point]); }) ||
         std::any_of(edges.begin(), edges.end(), same);
}

}  // namespace talus
