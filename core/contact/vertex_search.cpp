#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/units.hpp"
#include "contact/cones.hpp"
#include "contact/contact_points.hpp"

namespace talus {
namespace {

constexpr double outside = 1e-6;  // share by which a projection may miss a facet, so that none falls between two

/// Of a point with a vertex: the facet of the other body.
int facet_below(const StepGeometry& step, const FoundPoint& p) {
  const int own = step.features.facets[step.features.facets_at(p.node)[0]].body;
  return p.facets[step.features.facets[p.facets[0]].body == own ? 1 : 0];
}

Vec3 centre(const StepGeometry& step, int facet) {
  const auto& n = step.features.facets[facet].nodes;
  return (step.x[n[0]] + step.x[n[1]] + step.x[n[2]]) / 3;
}

/// Calls `visit` with the normals of the facets across convex creases that the point `p` on `facet` is near, and how
/// far it is from them.
template <class Visit>
void beyond_creases(const StepGeometry& step, int facet, const Vec3& p, double near, const Visit& visit) {
  const ContactFacet& f = step.features.facets[facet];
  const auto visit_if_convex = [&](int beyond, const Vec3& on_crease, double distance) {
    if (!(distance < near) || step.features.facets[beyond].patch == f.patch) return;
    const Vec3 n = step.fresh_normal(beyond), across = centre(step, facet) - on_crease;
    if (n.dot(across) < -cone_tolerance(step.settings) * across.norm()) visit(n, distance);
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

/// Is a point that lies below a facet outside the body all the same, beyond a convex crease of the facet? Where the
/// crease is sharp, the point still projects onto the facet. Where it is square, no more may be missed than by
/// projection.
bool beside_the_body(const StepGeometry& step, int facet, const Vec3& p) {
  const ContactFacet& f = step.features.facets[facet];
  return std::any_of(f.edges.begin(), f.edges.end(), [&](int edge) {
    const ContactEdge& e = step.features.edges[edge];
    const int beyond = e.facets[0] + e.facets[1] - facet;
    if (step.features.facets[beyond].patch == f.patch) return false;
    const Vec3 n = step.fresh_normal(beyond), on_crease = step.x[e.nodes[0]], across = centre(step, facet) - on_crease;
    const double below = -n.dot(across);
    return below > cone_tolerance(step.settings) * across.norm() && n.dot(p - on_crease) > outside * 3 * below;
  });
}

/// Whether the node, or an edge that ends there, may lie on a facet of this normal.
bool bears(const StepGeometry& step, int node, const Vec3& normal) {
  const double tolerance = cone_tolerance(step.settings);
  return rise(step, node, normal) >= -tolerance || an_edge_lies_along(step, node, normal, tolerance);
}

/// Whether a facet at the node looks against `normal`. The edges around a vertex amid a flat face rise neither way: on
/// a plate it would else touch what is beyond the plate too.
bool looks_against(const StepGeometry& step, int node, const Vec3& normal) {
  const auto facets = step.features.facets_at(node);
  return std::any_of(facets.begin(), facets.end(), [&](int f) { return step.fresh_normal(f).dot(normal) < 0; });
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
    const double along = step.fresh_normal(f).dot(normal);
    if (along < most) most = along, side.facet = f;
    if (side.joint < 0) side.joint = step.common_joint(f, facet);
  }
  return side;
}

}  // namespace

void VertexSearch::find(const StepGeometry& step, std::span<const FacetPair> pairs, FoundPoints& found) {
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

bool VertexSearch::has(int node, int patch) const {
  return std::binary_search(taken_.begin(), taken_.end(), vertex_key(node, patch));
}

void VertexSearch::touch(const StepGeometry& step, int node, int facet, bool node_is_first) {
  const ContactFacet& f = step.features.facets[facet];
  const Vec3 &n = step.normals[facet], &origin = step.x[f.nodes[0]];
  const Vec3 r = step.x[node] - origin;
  const double gap = n.dot(r);
  if (!(gap <= step.reach)) return;
  const int other = step.features.facets[step.features.facets_at(node)[0]].body;
  if (gap < 0 && gap < -step.depth(f.body, other)) return;

  const Vec3 e1 = step.x[f.nodes[1]] - origin, e2 = step.x[f.nodes[2]] - origin, twice = e1.cross(e2);
  const double squared = twice.squaredNorm();
  if (!(squared > 0)) return;
  const double s1 = r.cross(e2).dot(twice) / squared, s2 = e1.cross(r).dot(twice) / squared, s0 = 1 - s1 - s2;
  const double inside = std::min({s0, s1, s2});
  if (!(inside >= -outside)) return;

  const std::uint64_t key = vertex_key(node, f.patch);
  if (std::binary_search(taken_.begin(), taken_.end(), key)) return;
  if (!bears(step, node, n) || !looks_against(step, node, n)) return;
  if (gap < 0 && beside_the_body(step, facet, step.x[node])) return;
  // An edge that reaches back over the facet lies on it, though it ends at the crease.
  const auto lies_beyond = [&](const Vec3& beyond) {
    return rise(step, node, beyond) >= -cone_tolerance(step.settings);
  };
  if (gap < -step.seen_depth(f.body, other) && step.came_past_a_crease(facet, {&step.x[node], 1}, other, lies_beyond))
    return;
  touches_.push_back({key, node, facet, node_is_first, {s0, s1, s2}, inside});
}

void VertexSearch::add(const StepGeometry& step, const Touch& t, FoundPoints& found) {
  const ContactFacet& f = step.features.facets[t.facet];
  const Vec3& n = step.normals[t.facet];
  const OwnSide own = own_side(step, t.node, t.facet, n);
  const int own_patch = step.features.facets[own.facet].patch;

  FoundPoint p{};
  p.key = t.key;
  p.kind = PointKind::vertex;
  p.facets = t.node_is_first ? std::array{own.facet, t.facet} : std::array{t.facet, own.facet};
  p.patches = t.node_is_first ? std::array{own_patch, f.patch} : std::array{f.patch, own_patch};
  p.family = patch_family(p.patches[0], p.patches[1]);
  p.node = t.node;
  p.joint = own.joint;
  p.normal = t.node_is_first ? n : Vec3(-n);
  held_.push_back({t.node, static_cast<int>(found.points.size()), f.body, n});
  found.add_vertex(p, f.nodes, t.shares, t.node_is_first, step.features, step.x);
}

void VertexSearch::drop_false(const StepGeometry& step, FoundPoints& found) {
  std::sort(held_.begin(), held_.end(),
            [](const Held& p, const Held& q) { return p.node != q.node ? p.node < q.node : p.point < q.point; });
  for (std::size_t begin = 0, end = 0; begin < held_.size(); begin = end) {
    while (end < held_.size() && held_[end].node == held_[begin].node) ++end;
    const std::span<const Held> group(held_.data() + begin, end - begin);
    for (const Held& h : group) {
      if (h.point < 0 || found.points[h.point].kind != PointKind::vertex) continue;
      FoundPoint& p = found.points[h.point];
      p.dropped = beyond_rim(step, p, h, group, found) || deeper(step, p, h, group, found);
    }
  }
}

/// Within the rim of a convex crease a vertex is past it where something flush with the neighbour holds it: else a
/// corner that rests on one slab would catch on the side of the next. Where all its edges lie beyond the crease it is
/// passing, unless it points at this facet. An edge that reaches back over the facet lies on it, though it ends at the
/// rim.
bool VertexSearch::beyond_rim(const StepGeometry& step, const FoundPoint& p, const Held& h, std::span<const Held> group,
                              const FoundPoints& found) const {
  const int facet = facet_below(step, p), own = step.features.facets[step.features.facets_at(p.node)[0]].body;
  const Vec3 projection = step.x[p.node] - p.gap * h.normal;
  const bool points_at_it = rise(step, p.node, h.normal) > cone_tolerance(step.settings);
  bool drop = false;
  beyond_creases(step, facet, projection, step.widest_rim(h.body, own), [&](const Vec3& beyond, double distance) {
    const bool passes = !points_at_it && rise(step, p.node, beyond) >= -cone_tolerance(step.settings);
    if (passes && step.within_rim(distance, h.body, own, beyond)) drop = true;
    if (!(distance < step.rim(h.body, own))) return;
    for (const Held& other : group) {
      const bool holds = other.body != h.body && (other.point < 0 || found.points[other.point].gap <= step.reach);
      if (holds && other.normal.dot(beyond) > std::cos(radians(flush_angle))) drop = true;
    }
  });
  return drop;
}

/// Of two facets of one body that meet convexly, a vertex that is inside both has come through the nearer one; one at
/// which only edges bear may have an edge on each.
bool VertexSearch::deeper(const StepGeometry& step, const FoundPoint& p, const Held& h, std::span<const Held> group,
                          const FoundPoints& found) const {
  if (!(p.gap < 0) || rise(step, p.node, h.normal) < -cone_tolerance(step.settings)) return false;
  const int facet = facet_below(step, p);
  for (const Held& other : group) {
    if (other.point < 0 || other.point == h.point || other.body != h.body) continue;
    const FoundPoint& q = found.points[other.point];
    if (!(q.gap < 0)) continue;
    const int neighbour = facet_below(step, q);
    const Vec3 across = centre(step, facet) - centre(step, neighbour);
    const bool convex = other.normal.dot(across) < 0 && h.normal.dot(across) > 0;
    const bool tie = p.gap == q.gap && p.key > q.key && q.kind == PointKind::vertex;
    if (convex && (p.gap < q.gap || tie)) return true;
  }
  return false;
}

/// Two corners in one place may each lie on a facet of the other: one contact, through the nearer facet.
void VertexSearch::drop_doubled(const StepGeometry& step, FoundPoints& found) {
  const auto pushes = [&](const Held& h) {
    if (h.point < 0) return false;
    const FoundPoint& p = found.points[h.point];
    return p.kind == PointKind::vertex && !p.dropped && p.gap < 0;
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
    const double rim = step.rim(below.body, step.features.facets[step.features.facets_at(h.node)[0]].body);
    for (const int corner : below.nodes) {
      if ((step.x[corner] - step.x[h.node]).norm() > rim) continue;
      const auto [begin, end] = std::equal_range(held_.begin(), held_.end(), Held{corner, 0, 0, {}},
                                                 [](const Held& a, const Held& b) { return a.node < b.node; });
      p.dropped = p.dropped || std::any_of(begin, end, [&](const Held& q) { return pushes(q) && stands_for(q, h); });
    }
  }
}

}  // namespace talus
