#include "contact/narrow/vertex_face_search.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/units.hpp"
#include "contact/narrow/normal_cones.hpp"

namespace talus {
namespace {

/// Of a point with a vertex: the facet of the other body.
int facet_below(const StepGeometry& step, const FoundPoint& p) {
  const int own = step.features.body_of(p.node);
  return p.facets[step.features.facets[p.facets[0]].body == own ? 1 : 0];
}

Vec3 centre(const StepGeometry& step, int facet) {
  const auto& n = step.features.facets[facet].nodes;
  return (step.x[n[0]] + step.x[n[1]] + step.x[n[2]]) / 3;
}

/// Calls `visit` with the normals of the facets across those convex sharp edges of `facet` that its point `p` is nearer
/// to than `near` [m], and how far it is from them [m].
template <class Visit>
void visit_across_sharp_edges(const StepGeometry& step, int facet, const Vec3& p, double near, const Visit& visit) {
  const ContactFacet& f = step.features.facets[facet];
  const auto visit_if_convex = [&](int across, const Vec3& on_edge, double distance) {
    if (!(distance < near) || step.features.facets[across].smooth_face == f.smooth_face) return;
    const Vec3 &n = step.normal(across), inwards = centre(step, facet) - on_edge;
    if (n.dot(inwards) < -step.cone_tolerance() * inwards.norm()) visit(n, distance);
  };
  for (int k = 0; k < 3; ++k) {
    const ContactEdge& e = step.features.edges[f.edges[k]];
    const Vec3 from = step.x[e.nodes[0]], along = (step.x[e.nodes[1]] - from).stableNormalized(), r = p - from;
    visit_if_convex(e.facets[0] + e.facets[1] - facet, from, (r - along * along.dot(r)).norm());
    const Vec3& node = step.x[f.nodes[k]];
    const double from_node = (p - node).norm();
    if (!(from_node < near)) continue;
    for (int other : step.features.facets_at(f.nodes[k])) visit_if_convex(other, node, from_node);
  }
}

/// Is a point that lies below a facet outside the body all the same, past a convex sharp edge of the facet? Where that
/// edge is acute, the point still projects onto the facet. Where it is square, a point counts as past it only if it
/// would miss the facet by projection, too.
bool beside_the_body(const StepGeometry& step, int facet, const Vec3& p) {
  const ContactFacet& f = step.features.facets[facet];
  return std::any_of(f.edges.begin(), f.edges.end(), [&](int edge) {
    const ContactEdge& e = step.features.edges[edge];
    const int across = e.facets[0] + e.facets[1] - facet;
    if (step.features.facets[across].smooth_face == f.smooth_face) return false;
    const Vec3 &n = step.normal(across), &on_edge = step.x[e.nodes[0]], inwards = centre(step, facet) - on_edge;
    const double below = -n.dot(inwards);
    return below > step.cone_tolerance() * inwards.norm() &&
           n.dot(p - on_edge) > step.tolerances.outside_facet * 3 * below;
  });
}

/// Whether the node, or an edge that ends there, may lie on a facet of this normal.
bool may_touch(const StepGeometry& step, int node, const Vec3& normal) {
  const double tolerance = step.cone_tolerance();
  return rise(step, node, normal) >= -tolerance || an_edge_lies_along(step, node, normal, tolerance);
}

/// Whether a facet at the node looks against `normal`. The edges around a vertex amid a flat face rise to neither side:
/// a vertex of a plate would else touch what is on the plate's far side, too.
bool looks_against(const StepGeometry& step, int node, const Vec3& normal) {
  const auto facets = step.features.facets_at(node);
  return std::any_of(facets.begin(), facets.end(), [&](int f) { return step.normal(f).dot(normal) < 0; });
}

/// The facet at a node that looks most against `normal`, or the one there with the facet's joint.
struct OwnSide {
  int facet;
  int joint;
};
OwnSide own_side(const StepGeometry& step, int node, int facet, const Vec3& normal) {
  OwnSide side{-1, -1};
  double most = 2;
  for (int f : step.features.facets_at(node)) {
    const double along = step.normal(f).dot(normal);
    if (along < most) most = along, side.facet = f;
    if (side.joint < 0) side.joint = step.common_joint(f, facet);
  }
  return side;
}

}  // namespace

void VertexFaceSearch::find(const StepGeometry& step, std::span<const FacetPair> pairs, FoundPoints& found) {
  taken_.clear();
  held_.clear();
  for (std::size_t i = 0; i < found.points.size(); ++i) {
    const FoundPoint& p = found.points[i];
    taken_.push_back(p.key);
    if (p.node < 0) continue;
    const int below = facet_below(step, p);
    const bool first = below == p.facets[1];
    held_.push_back(
        {p.node, static_cast<int>(i), step.features.facets[below].body, first ? p.normal : Vec3(-p.normal)});
  }
  for (const FoundPoints::Covered& c : found.covered) {
    taken_.push_back(c.key);
    held_.push_back({c.node, -1, step.features.facets[c.facet].body, c.normal});
  }
  std::sort(taken_.begin(), taken_.end());

  touches_.clear();
  for (const FacetPair& pair : pairs) {
    const ContactFacet &a = step.features.facets[pair.a], &b = step.features.facets[pair.b];
    for (int k = 0; k < 3; ++k) {
      if (a.owns_node[k]) touch(step, a.nodes[k], pair.b, true);
      if (b.owns_node[k]) touch(step, b.nodes[k], pair.a, false);
    }
  }
  std::sort(touches_.begin(), touches_.end(), [](const Touch& p, const Touch& q) {
    if (p.key != q.key) return p.key < q.key;
    return p.inside != q.inside ? p.inside > q.inside : p.facet < q.facet;
  });
  for (std::size_t i = 0; i < touches_.size(); ++i) {
    if (i == 0 || touches_[i].key != touches_[i - 1].key) add(step, touches_[i], found);
  }
  drop_false(step, found);
  drop_doubled(step, found);

  for (const Touch& t : touches_) taken_.push_back(t.key);
  std::sort(taken_.begin(), taken_.end());
}

bool VertexFaceSearch::has(int node, int smooth_face) const {
  return std::binary_search(taken_.begin(), taken_.end(), vertex_key(node, smooth_face));
}

void VertexFaceSearch::touch(const StepGeometry& step, int node, int facet, bool node_is_first) {
  const ContactFacet& f = step.features.facets[facet];
  const Vec3 &n = step.normal(facet), &origin = step.x[f.nodes[0]];
  const Vec3 r = step.x[node] - origin;
  const double gap = n.dot(r);
  if (!(gap <= step.reach)) return;
  const int other = step.features.body_of(node);
  if (gap < 0 && gap < -step.depth(f.body, other)) return;

  const Vec3 e1 = step.x[f.nodes[1]] - origin, e2 = step.x[f.nodes[2]] - origin, twice = e1.cross(e2);
  const double squared = twice.squaredNorm();
  if (!(squared > 0)) return;
  const double s1 = r.cross(e2).dot(twice) / squared, s2 = e1.cross(r).dot(twice) / squared, s0 = 1 - s1 - s2;
  const double inside = std::min({s0, s1, s2});
  if (!(inside >= -step.tolerances.outside_facet)) return;

  const std::uint64_t key = vertex_key(node, f.smooth_face);
  if (std::binary_search(taken_.begin(), taken_.end(), key)) return;
  if (!may_touch(step, node, n) || !looks_against(step, node, n)) return;
  if (gap < 0 && beside_the_body(step, facet, step.x[node])) return;
  // An edge that reaches back over the facet lies on it, though it ends at the sharp edge.
  const auto lies_across = [&](const Vec3& across) { return rise(step, node, across) >= -step.cone_tolerance(); };
  if (gap < -step.noticeable_depth(f.body, other) &&
      step.came_past_sharp_edge(facet, {&step.x[node], 1}, other, lies_across))
    return;
  touches_.push_back({key, node, facet, node_is_first, {s0, s1, s2}, inside});
}

void VertexFaceSearch::add(const StepGeometry& step, const Touch& t, FoundPoints& found) {
  const ContactFacet& f = step.features.facets[t.facet];
  const Vec3& n = step.normal(t.facet);
  const OwnSide own = own_side(step, t.node, t.facet, n);
  const int own_face = step.features.facets[own.facet].smooth_face;

  FoundPoint p{};
  p.key = t.key;
  p.kind = PointKind::vertex_face;
  p.facets = t.node_is_first ? std::array{own.facet, t.facet} : std::array{t.facet, own.facet};
  p.smooth_faces = t.node_is_first ? std::array{own_face, f.smooth_face} : std::array{f.smooth_face, own_face};
  p.family = face_family(p.smooth_faces[0], p.smooth_faces[1]);
  p.node = t.node;
  p.joint = own.joint;
  p.normal = t.node_is_first ? n : Vec3(-n);
  held_.push_back({t.node, static_cast<int>(found.points.size()), f.body, n});
  found.add_vertex(p, f.nodes, t.at, t.node_is_first, step.features, step.x);
}

void VertexFaceSearch::drop_false(const StepGeometry& step, FoundPoints& found) {
  std::sort(held_.begin(), held_.end(),
            [](const Held& p, const Held& q) { return p.node != q.node ? p.node < q.node : p.point < q.point; });
  for (std::size_t begin = 0, end = 0; begin < held_.size(); begin = end) {
    while (end < held_.size() && held_[end].node == held_[begin].node) ++end;
    const std::span<const Held> group(held_.data() + begin, end - begin);
    for (const Held& h : group) {
      if (h.point < 0 || found.points[h.point].kind != PointKind::vertex_face) continue;
      FoundPoint& p = found.points[h.point];
      p.dropped = past_sharp_edge(step, p, h, group, found) || deeper(step, p, h, group, found);
    }
  }
}

/// Within the edge tolerance of a convex sharp edge a vertex is past it where something flush with the facet across
/// holds it: else a corner that rests on one slab would catch on the side of the next. Where all its edges lie past the
/// sharp edge it is passing, unless it points at this facet. An edge that reaches back over the facet lies on it,
/// though it ends at the sharp edge.
bool VertexFaceSearch::past_sharp_edge(const StepGeometry& step, const FoundPoint& p, const Held& h,
                                       std::span<const Held> group, const FoundPoints& found) const {
  const int facet = facet_below(step, p), own = step.features.body_of(p.node);
  const Vec3 projection = step.x[p.node] - p.gap * h.normal;
  const bool points_at_it = rise(step, p.node, h.normal) > step.cone_tolerance();
  const double flush = std::cos(radians(step.tolerances.flush_angle));
  bool drop = false;
  visit_across_sharp_edges(
      step, facet, projection, step.largest_edge_tolerance(h.body, own), [&](const Vec3& across, double distance) {
        const bool passes = !points_at_it && rise(step, p.node, across) >= -step.cone_tolerance();
        if (passes && step.within_edge_tolerance(distance, h.body, own, across)) drop = true;
        if (!(distance < step.edge_tolerance(h.body, own))) return;
        for (const Held& other : group) {
          const bool holds = other.body != h.body && (other.point < 0 || found.points[other.point].gap <= step.reach);
          if (holds && other.normal.dot(across) > flush) drop = true;
        }
      });
  return drop;
}

/// Of two facets of one body that form a convex edge, a vertex that is inside both has come through the nearer one; one
/// at which only edges touch may have an edge on each.
bool VertexFaceSearch::deeper(const StepGeometry& step, const FoundPoint& p, const Held& h, std::span<const Held> group,
                              const FoundPoints& found) const {
  if (!(p.gap < 0) || rise(step, p.node, h.normal) < -step.cone_tolerance()) return false;
  const int facet = facet_below(step, p);
  for (const Held& other : group) {
    if (other.point < 0 || other.point == h.point || other.body != h.body) continue;
    const FoundPoint& q = found.points[other.point];
    if (!(q.gap < 0)) continue;
    const int neighbour = facet_below(step, q);
    const Vec3 across = centre(step, facet) - centre(step, neighbour);
    const bool convex = other.normal.dot(across) < 0 && h.normal.dot(across) > 0;
    const bool tie = p.gap == q.gap && p.key > q.key && q.kind == PointKind::vertex_face;
    if (convex && (p.gap < q.gap || tie)) return true;
  }
  return false;
}

/// Two corners in one place may each lie on a facet of the other: one contact, through the nearer facet.
void VertexFaceSearch::drop_doubled(const StepGeometry& step, FoundPoints& found) {
  const auto pushes = [&](const Held& h) {
    if (h.point < 0) return false;
    const FoundPoint& p = found.points[h.point];
    return p.kind == PointKind::vertex_face && !p.dropped && p.gap < 0;
  };
  const auto stands_for = [&](const Held& other, const Held& h) {
    const FoundPoint &p = found.points[h.point], &q = found.points[other.point];
    const auto& nodes = step.features.facets[facet_below(step, q)].nodes;
    return std::find(nodes.begin(), nodes.end(), h.node) != nodes.end() &&
           (q.gap != p.gap ? q.gap > p.gap : q.key < p.key);
  };
  for (const Held& h : held_) {
    if (!pushes(h)) continue;
    FoundPoint& p = found.points[h.point];
    const ContactFacet& below = step.features.facets[facet_below(step, p)];
    const double edge_tolerance = step.edge_tolerance(below.body, step.features.body_of(h.node));
    for (const int corner : below.nodes) {
      if ((step.x[corner] - step.x[h.node]).norm() > edge_tolerance) continue;
      const auto [begin, end] = std::equal_range(held_.begin(), held_.end(), Held{corner, 0, 0, {}},
                                                 [](const Held& a, const Held& b) { return a.node < b.node; });
      p.dropped = p.dropped || std::any_of(begin, end, [&](const Held& q) { return pushes(q) && stands_for(q, h); });
    }
  }
}

}  // namespace talus
