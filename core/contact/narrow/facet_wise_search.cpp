#include "contact/narrow/facet_wise_search.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "contact/narrow/common_plane.hpp"

namespace talus {
namespace {

Triangle corners(const StepGeometry& step, int facet) {
  const auto& n = step.features.facets[facet].nodes;
  return {step.x[n[0]], step.x[n[1]], step.x[n[2]]};
}

}  // namespace

void FacetWiseSearch::find(const StepGeometry& step, std::span<const FacePair> pairs, FoundPoints& found) {
  touches_.clear();
  for (const FacePair& pair : pairs)
    touch(step, {step.features.faces[pair.a].facet, step.features.faces[pair.b].facet});
  // Two facets at a vertex or an edge find the same contact: one spring. Facets that overlap have the best normal, else
  // those with the widest gap, as among the candidate planes.
  std::sort(touches_.begin(), touches_.end(), [](const Touch& p, const Touch& q) {
    if (p.key != q.key) return p.key < q.key;
    if ((p.area > 0) != (q.area > 0)) return p.area > 0;
    return p.gap != q.gap ? p.gap > q.gap : p.order < q.order;
  });
  const auto& facets = step.features.facets;
  for (std::size_t i = 0, end = 0; i < touches_.size(); i = end) {
    const Touch& t = touches_[i];
    FoundPoint p{};
    for (; end < touches_.size() && touches_[end].key == t.key; ++end) p.area += touches_[end].area;
    p.key = t.key;
    p.kind = t.area > 0 ? PointKind::face_face : t.node >= 0 ? PointKind::vertex_face : PointKind::edge_edge;
    p.facets = {t.facets.a, t.facets.b};
    p.smooth_faces = {facets[t.facets.a].smooth_face, facets[t.facets.b].smooth_face};
    p.family = face_family(p.smooth_faces[0], p.smooth_faces[1]);
    p.node = t.node;
    p.joint = step.common_joint(t.facets.a, t.facets.b);
    p.normal = t.normal;
    if (t.node < 0) {
      const ContactEdge &a = step.features.edges[t.edges[0]], &b = step.features.edges[t.edges[1]];
      found.add_between(p, a.nodes, t.at[0], b.nodes, t.at[1], step.features, step.x);
    } else {
      const auto& own = facets[t.facets.a].nodes;
      const bool node_is_first = std::find(own.begin(), own.end(), t.node) != own.end();
      const ContactFacet& other = facets[node_is_first ? t.facets.b : t.facets.a];
      found.add_vertex(p, other.nodes, t.at, node_is_first, step.features, step.x);
    }
  }
}

void FacetWiseSearch::touch(const StepGeometry& step, const FacetPair& pair) {
  const Vec3 &na = step.normal(pair.a), &nb = step.normal(pair.b);
  const CommonPlane plane = common_plane(corners(step, pair.a), corners(step, pair.b), nb - na, step.tolerances);
  if (!plane.converged) step.count(step.work.unfinished_planes);
  const auto& facets = step.features.facets;
  const double reach = step.reach(facets[pair.a].body, facets[pair.b].body);
  if (!(plane.gap <= reach) || std::min(plane.normal.dot(nb), -plane.normal.dot(na)) < step.cone_tolerance)
    return;  // apart, or the plane sees one of them on edge or from behind
  const std::size_t first = touches_.size();
  vertices_on(step, pair, true, plane.normal);
  vertices_on(step, pair, false, plane.normal);
  crossings(step, pair, plane.normal);

  const double least_cosine = step.face_face_cosine;
  if (first == touches_.size() || plane.normal.dot(nb) < least_cosine || -plane.normal.dot(na) < least_cosine) return;
  const double each = common_area(step, pair, plane.normal) / static_cast<double>(touches_.size() - first);
  for (std::size_t i = first; i < touches_.size(); ++i) touches_[i].area = each;
}

/// Area that two facets have in common, seen along n. [m²]
double FacetWiseSearch::common_area(const StepGeometry& step, const FacetPair& pair, const Vec3& n) {
  const Vec3 e1 = n.unitOrthogonal(), e2 = n.cross(e1);
  const Triangle a = corners(step, pair.a), b = corners(step, pair.b);
  const auto flat = [&](const Vec3& p) { return Vec2((p - a[0]).dot(e1), (p - a[0]).dot(e2)); };
  const std::array flat_a{flat(a[2]), flat(a[1]), flat(a[0])}, flat_b{flat(b[0]), flat(b[1]), flat(b[2])};
  overlap(flat_a, flat_b, step.tolerances, overlap_);
  return overlap_.area;
}

void FacetWiseSearch::keep(const StepGeometry& step, Touch touch) {
  const auto& facets = step.features.facets;
  const int a = facets[touch.facets.a].body, b = facets[touch.facets.b].body;
  if (!(touch.gap <= step.reach(a, b)) || touch.gap < -step.depth(a, b)) return;
  touch.order = static_cast<int>(touches_.size());
  touches_.push_back(touch);
}

/// Vertices of one facet that lie on the other, seen along n.
void FacetWiseSearch::vertices_on(const StepGeometry& step, const FacetPair& pair, bool node_is_first, const Vec3& n) {
  const int own = node_is_first ? pair.a : pair.b, other = node_is_first ? pair.b : pair.a;
  const double sense = node_is_first ? 1 : -1;
  const auto& nodes = step.features.facets[other].nodes;
  const Vec3 &origin = step.x[nodes[0]], e1 = step.x[nodes[1]] - origin, e2 = step.x[nodes[2]] - origin;
  const double volume = n.dot(e1.cross(e2));
  for (int node : step.features.facets[own].nodes) {
    const Vec3 r = step.x[node] - origin;
    const double s1 = n.dot(r.cross(e2)) / volume, s2 = n.dot(e1.cross(r)) / volume, s0 = 1 - s1 - s2;
    if (!(std::min({s0, s1, s2}) >= -step.tolerances.outside_facet)) continue;
    const double gap = sense * n.dot(r - s1 * e1 - s2 * e2);
    keep(step, {vertex_key(node, other), 0, pair, n, gap, 0, node, {}, {s0, s1, s2}});
  }
}

/// Edges that cross, seen along n. A crossing at an end is the vertex's.
void FacetWiseSearch::crossings(const StepGeometry& step, const FacetPair& pair, const Vec3& n) {
  for (int edge_a : step.features.facets[pair.a].edges) {
    for (int edge_b : step.features.facets[pair.b].edges) {
      const ContactEdge &a = step.features.edges[edge_a], &b = step.features.edges[edge_b];
      const Vec3 &a0 = step.x[a.nodes[0]], &b0 = step.x[b.nodes[0]];
      const Vec3 u = step.x[a.nodes[1]] - a0, w = step.x[b.nodes[1]] - b0, r = b0 - a0;
      const double volume = n.dot(u.cross(w));
      if (!(volume * volume > step.tolerances.parallel_edges * u.squaredNorm() * w.squaredNorm())) continue;
      const double s = n.dot(r.cross(w)) / volume, t = n.dot(r.cross(u)) / volume;
      if (!(std::min({s, t, 1 - s, 1 - t}) > step.tolerances.outside_facet)) continue;
      keep(step, {edge_key(edge_a, edge_b), 0, pair, n, n.dot(s * u - t * w - r), 0, -1, {edge_a, edge_b}, {s, t, 0}});
    }
  }
}

}  // namespace talus
