#include "contact/narrow/vertex_face_search.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/narrow/normal_cones.hpp"
#include "contact/narrow/valley.hpp"

namespace talus {
namespace {

/// Is a vertex that lies below a face, at `p`, outside the body all the same, past a convex sharp edge of the face?
/// Where that edge is acute, it still projects onto the face. Where it is square, it counts as past it only if it would
/// miss the face by projection, too. Past it by no more than the edge tolerance it is outside only if its body lies
/// there, too: one that stands beside the face may have sunk below the edge by as much.
bool beside_the_body(const StepGeometry& step, int node, int face, const Vec3& p) {
  const double near = step.edge_tolerance(step.features.faces[face].body, step.features.body_of(node));
  const Vec3 centre = step.centre(face);
  const auto sides = step.features.sides(face);
  return std::any_of(sides.begin(), sides.end(), [&](int edge) {
    const ContactEdge& e = step.features.edges[edge];
    if (!e.is_sharp || !step.shapes.edge(edge).is_clearly_convex) return false;
    const Vec3 &n = step.normal(step.features.across(edge, face)), &on_edge = step.x[e.nodes[0]];
    const double past = n.dot(p - on_edge);
    if (!(past > step.tolerances.outside_facet * 3 * n.dot(on_edge - centre))) return false;
    return past > near || is_in_cone(step, node, n);
  });
}

/// Whether a vertex past a reentrant edge of a face, `past` [m] beside it in its plane, meets the face there. Behind
/// the face it does while it is hardly past; before it where it can come down along the side across the edge in this
/// step.
bool meets_past_valley(const StepGeometry& step, const Vec3& p, int face, int edge, double past, double gap,
                       int other) {
  const int body = step.features.faces[face].body, across = step.features.across(edge, face);
  if (gap < 0) return past <= reach_past_valley(-step.face_normal(face).dot(step.normal(across)), -gap);
  const double above_across = step.normal(across).dot(p - step.x[step.features.edges[edge].nodes[0]]);
  return past <= step.reach(body, other) && above_across >= -step.edge_tolerance(body, other);
}

/// Where a vertex of the body `other` is on a face, or would be, had its body not sunk over a convex sharp edge of it:
/// at the edge; and at a reentrant edge that it is past and meets the face at. `gap`: from the face [m].
struct HeldPlace {
  Vec3 at;
  Vec3 across;             ///< normal of the facet across the convex edge; zero where it has not sunk over one
  bool is_beside = false;  ///< as FoundPoint's
};
HeldPlace held_place(const StepGeometry& step, int node, int face, int other, double gap) {
  const int body = step.features.faces[face].body;
  const Vec3& p = step.x[node];
  const double near = step.edge_tolerance(body, other);
  for (const int edge : step.features.sides(face)) {
    const ContactEdge& e = step.features.edges[edge];
    const FeatureShapes::Edge& shape = step.shapes.edge(edge);
    if (!e.is_sharp || shape.is_convex) continue;
    const Vec3& into = shape.into[step.features.facets[e.facets[0]].face == face ? 0 : 1];
    const double past = -into.dot(p - step.x[e.nodes[0]]);
    if (past > 0 && meets_past_valley(step, p, face, edge, past, gap, other))
      return {p + past * into, Vec3::Zero(), gap >= 0};
  }
  if (-gap > near) return {p, Vec3::Zero()};
  for (const int edge : step.features.sides(face)) {
    const ContactEdge& e = step.features.edges[edge];
    if (!e.is_sharp) continue;
    const FeatureShapes::Edge& shape = step.shapes.edge(edge);
    if (!shape.is_convex) continue;
    const int across = step.features.across(edge, face);
    const Vec3 &outward = step.normal(across), r = p - step.x[e.nodes[0]];
    const double past = outward.dot(r);
    if (std::abs(past) > near || std::abs(past) > step.sunk_past_edge(other, body, outward)) continue;
    const Vec3& into = shape.into[e.facets[0] == across ? 1 : 0];
    return {p + std::max({0.0, -into.dot(r), past / -into.dot(outward)}) * into, outward};
  }
  return {p, Vec3::Zero()};
}

/// Whether the node, or an edge that ends there, may lie on a facet of this normal.
bool may_touch(const StepGeometry& step, int node, const Vec3& normal) {
  return is_in_cone(step, node, normal) || an_edge_lies_along(step, node, normal);
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

void VertexFaceSearch::find(const StepGeometry& step, const NearFeatures& near, SeparatingAxis& axis,
                            FoundPoints& found) {
  taken_.clear();
  for (const FoundPoint& p : found.points) taken_.push_back(p.key);
  for (const FoundPoints::Covered& c : found.covered) taken_.push_back(c.key);
  std::sort(taken_.begin(), taken_.end());

  touches_.clear();
  near.visit_bodies([&](const NearFeatures::OfBodies& of_bodies) {
    for (const NearFeatures::VertexAtFace& vertex : of_bodies.vertices) touch(step, vertex, of_bodies.depth, axis);
  });
  std::sort(touches_.begin(), touches_.end(), [](const Touch& p, const Touch& q) {
    if (p.key != q.key) return p.key < q.key;
    if (p.is_beside != q.is_beside) return q.is_beside;
    return p.inside != q.inside ? p.inside > q.inside : p.facet < q.facet;
  });
  for (std::size_t i = 0; i < touches_.size(); ++i) {
    if (i == 0 || touches_[i].key != touches_[i - 1].key) add(step, touches_[i], found);
  }
  for (const Touch& t : touches_)
    if (!t.is_beside) taken_.push_back(t.key);
  std::sort(taken_.begin(), taken_.end());
}

bool VertexFaceSearch::has(int node, int smooth_face) const {
  return std::binary_search(taken_.begin(), taken_.end(), vertex_key(node, smooth_face));
}

/// `depth`: how deep the two bodies can lie in each other. [m]
void VertexFaceSearch::touch(const StepGeometry& step, const NearFeatures::VertexAtFace& near, double depth,
                             SeparatingAxis& axis) {
  const auto& [node, face, node_is_first] = near;
  const ContactFace& f = step.features.faces[face];
  const Vec3& n = step.face_normal(face);
  const double gap = n.dot(step.x[node] - step.x[step.features.facets[f.facet].nodes[0]]);
  const int other = step.features.body_of(node);
  if (!(gap <= step.reach(f.body, other))) return;
  if (gap < 0 && gap < -depth) return;
  if (!may_touch(step, node, n) || !looks_against(step, node, n)) return;  // most do not
  const std::uint64_t key = vertex_key(node, f.smooth_face);
  if (std::binary_search(taken_.begin(), taken_.end(), key)) return;
  const HeldPlace held = held_place(step, node, face, other, gap);
  Touch t{key, node, -1, node_is_first, held.is_beside, {}, -step.tolerances.outside_facet};
  for (const int facet : step.features.facets_of(face)) locate(step, facet, held.at, t);
  if (t.facet < 0) return;
  const auto [first, second] = node_is_first ? std::pair(other, f.body) : std::pair(f.body, other);
  if (axis.refutes(step, first, second, gap)) return;
  const auto least_deep = [&] { return axis.confirms(step, first, second, gap); };
  if (gap < 0 && beside_the_body(step, node, face, held.at) && !least_deep()) return;
  // An edge that reaches back over the facet lies on it, though it ends at the sharp edge.
  const auto lies_across = [&](const Vec3& across) {
    return is_in_cone(step, node, across) && !(across.dot(held.across) > step.flush_cosine);
  };
  if (gap < -step.noticeable_depth(f.body, other) &&
      step.came_past_sharp_edge(face, {&step.x[node], 1}, other, lies_across, least_deep))
    return;
  touches_.push_back(t);
}

/// Whether the place of the vertex is on this facet, farther inside than on others of the same face.
void VertexFaceSearch::locate(const StepGeometry& step, int facet, const Vec3& place, Touch& t) {
  const auto& nodes = step.features.facets[facet].nodes;
  const Vec3 &origin = step.x[nodes[0]], r = place - origin;
  const Vec3 e1 = step.x[nodes[1]] - origin, e2 = step.x[nodes[2]] - origin, twice = e1.cross(e2);
  const double squared = twice.squaredNorm();
  if (!(squared > 0)) return;
  const double s1 = r.cross(e2).dot(twice) / squared, s2 = e1.cross(r).dot(twice) / squared, s0 = 1 - s1 - s2;
  const double inside = std::min({s0, s1, s2});
  if (!(inside >= t.inside)) return;
  t.facet = facet;
  t.at = {s0, s1, s2};
  t.inside = inside;
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
  p.is_beside = t.is_beside;
  found.add_vertex(p, f.nodes, t.at, t.node_is_first, step.features, step.x);
}

}  // namespace talus
