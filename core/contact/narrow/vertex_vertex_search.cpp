#include "contact/narrow/vertex_vertex_search.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "contact/history/contact_memory.hpp"
#include "contact/narrow/normal_cones.hpp"

namespace talus {
namespace {

constexpr std::size_t usual_faces = 16;  // around a corner; room for more is made when needed
constexpr int corner_bit = 1 << 30;      // of a key: a corner's node, else a sharp edge

std::uint64_t vertex_vertex_key(int node, int other) {
  return static_cast<std::uint64_t>(node) << 31 | static_cast<std::uint64_t>(other);
}

/// A node or an edge.
int first_feature(std::uint64_t key) { return static_cast<int>(key >> 31 & 0x7fffffff); }

void add_faces(const StepGeometry& step, std::span<const int> facets, std::vector<std::pair<int, Vec3>>& faces) {
  for (const int facet : facets) {
    const int smooth_face = step.features.facets[facet].smooth_face;
    const auto known = [&](const auto& face) { return face.first == smooth_face; };
    if (std::none_of(faces.begin(), faces.end(), known)) faces.emplace_back(smooth_face, step.normal(facet));
  }
}

}  // namespace

void add_pressures(std::span<const FoundPoint> points, const Reach& reach, Pressures& pressures) {
  for (const FoundPoint& p : points) {
    if (p.dropped || p.gap > reach(p.bodies[0], p.bodies[1])) continue;
    if (p.smooth_faces[0] >= 0) pressures.add(p.smooth_faces[0], {p.bodies[1], p.normal, p.position});
    if (p.smooth_faces[1] >= 0) pressures.add(p.smooth_faces[1], {p.bodies[0], -p.normal, p.position});
  }
}

void add_sights(std::span<const Sight> seen, Sights& sights) {
  for (const Sight& sight : seen) sights.add(first_feature(sight.key), sight);
}

VertexVertexSearch::VertexVertexSearch() {
  own_.faces.reserve(usual_faces);
  other_.faces.reserve(usual_faces);
}

void VertexVertexSearch::find(const StepGeometry& step, const NearFeatures& near, const Pressures& pressures,
                              const Sights& former, SeparatingAxis& axis, FoundPoints& found) {
  pressures_ = &pressures;
  former_ = &former;
  seen_.clear();
  others_.sort(found.points, [](const FoundPoint&) { return true; });
  near.visit_bodies([&](const NearFeatures::OfBodies& of_bodies) {
    list_face_face(of_bodies.bodies, found);
    find_candidates(step, of_bodies);
    first_ = found.points.size();
    for (std::size_t i = 0; i < candidates_.size(); ++i)
      if (i == 0 || candidates_[i].key != candidates_[i - 1].key) add(step, candidates_[i], axis, found);
  });
}

/// All of two bodies.
void VertexVertexSearch::find_candidates(const StepGeometry& step, const NearFeatures::OfBodies& near) {
  candidates_.clear();
  depth_ = near.depth;
  edge_tolerance_ = step.edge_tolerance(near.bodies[0], near.bodies[1]);
  far_ = step.farthest_cores(near.bodies[0], near.bodies[1]);
  for (const auto& [node, edge, node_is_first] : near.corners) add_vertex_at_edge(step, node, edge, node_is_first);
  for (const auto& [a, b] : near.parallel) add_edge_along_edge(step, a, b);
  std::sort(candidates_.begin(), candidates_.end(), [](const Candidate& p, const Candidate& q) {
    return p.key != q.key ? p.key < q.key : p.apart != q.apart ? p.apart < q.apart : p.other.edge < q.other.edge;
  });
}

/// A corner and an edge that may be near each other.
void VertexVertexSearch::add_vertex_at_edge(const StepGeometry& step, int node, int edge, bool node_is_first) {
  const ContactFeatures& features = step.features;
  const ContactEdge& e = features.edges[edge];
  const Vec3 &v = step.x[node], &p = step.x[e.nodes[0]], along = step.x[e.nodes[1]] - p;
  const double r = edge_tolerance_;
  const double nearest = std::clamp((v - p).dot(along) / along.squaredNorm(), 0.0, 1.0);
  if (!((v - p - nearest * along).squaredNorm() < far_ * far_) || !step.shapes.edge(edge).is_convex) return;
  if (face_face_holds(step, features.facets_at(node), e.facets, node_is_first)) return;

  const Vec3 core = v + r * step.shapes.towards_core(node);
  const Vec3 from = p + r * step.shapes.towards_core(e.nodes[0]);
  const Vec3 core_along = step.x[e.nodes[1]] + r * step.shapes.towards_core(e.nodes[1]) - from;
  const double fraction = std::clamp((core - from).dot(core_along) / core_along.squaredNorm(), 0.0, 1.0);
  const double apart = (core - from - fraction * core_along).norm();
  const int end = fraction == 0 ? e.nodes[0] : fraction == 1 ? e.nodes[1] : -1;
  if (end < 0 || !features.corner[end]) {
    candidates_.push_back(
        {vertex_vertex_key(node, e.sharp_edge), {node, -1, 0}, {-1, edge, fraction}, apart, node_is_first});
  } else {  // of two corners the first body's comes first
    const int first = node_is_first ? node : end, second = node_is_first ? end : node;
    candidates_.push_back(
        {vertex_vertex_key(first, corner_bit | second), {first, -1, 0}, {second, -1, 0}, apart, true});
  }
}

/// Two edges that cross at an angle so small that the direction across both is hardly defined. Where their ends part by
/// less than the edge tolerance, the ends have the contact.
void VertexVertexSearch::add_edge_along_edge(const StepGeometry& step, int edge_a, int edge_b) {
  const ContactFeatures& features = step.features;
  const ContactEdge &a = features.edges[edge_a], &b = features.edges[edge_b];
  const Vec3 u = step.x[a.nodes[1]] - step.x[a.nodes[0]], w = step.x[b.nodes[1]] - step.x[b.nodes[0]];
  const double uu = u.squaredNorm(), ww = w.squaredNorm(), squared = u.cross(w).squaredNorm();
  const double r = edge_tolerance_;
  if (!(squared > r * r * std::max(uu, ww))) return;
  if (face_face_holds(step, a.facets, b.facets, true)) return;

  const auto core = [&](int node) { return Vec3(step.x[node] + r * step.shapes.towards_core(node)); };
  const Vec3 p = core(a.nodes[0]), along_a = core(a.nodes[1]) - p;
  const Vec3 q = core(b.nodes[0]), along_b = core(b.nodes[1]) - q;
  const Vec3 across = along_a.cross(along_b), between = q - p;
  const double s = between.cross(along_b).dot(across) / across.squaredNorm();
  const double t = between.cross(along_a).dot(across) / across.squaredNorm();
  if (!(s > 0 && s < 1 && t > 0 && t < 1)) return;
  const double apart = (between + t * along_b - s * along_a).norm();
  candidates_.push_back({edge_key(edge_a, edge_b), {-1, edge_a, s}, {-1, edge_b, t}, apart, true});
}

namespace {

template <class Number>
void sort_once(std::vector<Number>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

}  // namespace

void VertexVertexSearch::list_face_face(const std::array<int, 2>& of_bodies, const FoundPoints& found) {
  face_face_families_.clear();
  for (std::vector<int>& faces : in_face_face_) faces.clear();
  for (const auto& [bodies, number] : others_.of(of_bodies)) {
    const FoundPoint& p = found.points[number];
    if (p.kind != PointKind::face_face || (!face_face_families_.empty() && face_face_families_.back() == p.family))
      continue;
    face_face_families_.push_back(p.family);
    for (int k = 0; k < 2; ++k) in_face_face_[k].push_back(p.smooth_faces[k]);
  }
  sort_once(face_face_families_);
  for (std::vector<int>& faces : in_face_face_) sort_once(faces);
}

std::span<const int> VertexVertexSearch::facets_at(const ContactFeatures& features, const Place& place) {
  if (place.node >= 0) return features.facets_at(place.node);
  return features.edges[place.edge].facets;
}

std::array<int, 2> VertexVertexSearch::ends_of(const ContactFeatures& features, const Place& place) {
  return place.node >= 0 ? std::array{place.node, place.node} : features.edges[place.edge].nodes;
}

/// Whether a direction from the other body into this one is opposite to one of the feature's normal cone.
bool VertexVertexSearch::in_cone(const StepGeometry& step, const Place& place, const Vec3& inwards) {
  if (place.node >= 0) return is_in_cone(step, place.node, inwards);
  const double tolerance = step.cone_tolerance;
  const std::array<Vec3, 2>& into = step.shapes.edge(place.edge).into;
  return into[0].dot(inwards) >= -tolerance && into[1].dot(inwards) >= -tolerance;
}

void VertexVertexSearch::take(const StepGeometry& step, const Place& place, Feature& feature) const {
  const auto ends = ends_of(step.features, place);
  const auto facets = facets_at(step.features, place);
  const auto core = [&](int node) { return Vec3(step.x[node] + edge_tolerance_ * step.shapes.towards_core(node)); };
  feature.body = step.features.facets[facets[0]].body;
  feature.place = step.x[ends[0]] + place.fraction * (step.x[ends[1]] - step.x[ends[0]]);
  feature.core = core(ends[0]) + place.fraction * (core(ends[1]) - core(ends[0]));
  feature.nodes = {-1, -1};
  feature.faces.clear();
  add_faces(step, facets, feature.faces);
  if (place.node >= 0) feature.nodes = ends;
  for (int k = 0; k < 2 && place.node < 0; ++k) {
    if ((step.x[ends[k]] - feature.place).norm() > edge_tolerance_) continue;
    feature.nodes[k] = ends[k];
    add_faces(step, step.features.facets_at(ends[k]), feature.faces);
  }
}

void VertexVertexSearch::add(const StepGeometry& step, const Candidate& m, SeparatingAxis& axis, FoundPoints& found) {
  const ContactFeatures& features = step.features;
  const auto own_facets = facets_at(features, m.own), other_facets = facets_at(features, m.other);
  if (face_face_holds(step, own_facets, other_facets, m.own_is_first)) return;
  const int own = features.facets[own_facets[0]].body, other = features.facets[other_facets[0]].body;
  take(step, m.own, own_);
  take(step, m.other, other_);
  const std::optional<Vec3> normal = normal_of(step, m);
  if (!normal) return;
  const Vec3& n = *normal;
  const double gap = n.dot(own_.place - other_.place);
  if (!(gap <= step.reach(own, other)) || gap < -depth_) return;
  if (m.own_is_first ? axis.refutes(step, own, other, gap) : axis.refutes(step, other, own, gap)) return;
  if (lies_flush(step, own_, other_) || lies_flush(step, other_, own_)) return;
  if (passes(step, m.key)) return;
  if (!stands_for_others(step, n, m.own_is_first, found)) return;

  FoundPoint p{};
  p.key = m.key;
  p.family = m.key;
  p.kind = PointKind::vertex_vertex;
  p.facets = {own_facets[0], other_facets[0]};
  p.smooth_faces = {-1, -1};
  p.node = m.own.node;
  p.joint = -1;
  for (const int f : own_facets) {
    for (const int g : other_facets) p.joint = std::max(p.joint, step.common_joint(f, g));
  }
  p.normal = n;
  Place first = m.own, second = m.other;
  if (!m.own_is_first) {
    std::swap(first, second);
    std::swap(p.facets[0], p.facets[1]);
    p.normal = -n;
  }
  found.add_between(p, ends_of(features, first), first.fraction, ends_of(features, second), second.fraction, features,
                    step.x);
}

/// Two features are nearest each other where the direction between them lies in the normal cones of both. That of
/// edges that cross is the one across both: the direction between cores that have passed each other would be the
/// opposite.
std::optional<Vec3> VertexVertexSearch::normal_of(const StepGeometry& step, const Candidate& m) const {
  const auto fits = [&](const Vec3& n) { return in_cone(step, m.own, n) && in_cone(step, m.other, -n); };
  Vec3 n = (own_.core - other_.core) / m.apart;
  if (m.own.node < 0 && m.other.node < 0) {
    const auto along = [&](const Place& place) {
      const auto& nodes = step.features.edges[place.edge].nodes;
      return Vec3(step.x[nodes[1]] - step.x[nodes[0]]);
    };
    n = along(m.own).cross(along(m.other)).normalized();
    if (!fits(n)) n = -n;
  } else if (!(m.apart > step.tolerances.least_core_distance * edge_tolerance_)) {
    return std::nullopt;
  }
  return fits(n) ? std::optional(n) : std::nullopt;
}

/// Where smooth faces around both features are in face–face contact, that one holds the place, too. But an acute corner
/// that has sunk into an acute edge overlaps both adjacent faces of it: there the far sides of the two are in contact,
/// and push against each other and hardly up.
bool VertexVertexSearch::face_face_holds(const StepGeometry& step, std::span<const int> facets,
                                         std::span<const int> others, bool are_first) {
  if (face_face_families_.empty()) return false;
  adjacent_faces_.clear();
  const std::vector<int>& touching = in_face_face_[are_first ? 0 : 1];
  for (const int f : facets) {
    const int a = step.features.facets[f].smooth_face;
    if (!std::binary_search(touching.begin(), touching.end(), a)) continue;
    for (const int g : others) {
      const int b = step.features.facets[g].smooth_face;
      const std::uint64_t family = are_first ? face_family(a, b) : face_family(b, a);
      if (std::binary_search(face_face_families_.begin(), face_face_families_.end(), family))
        adjacent_faces_.push_back({family, step.normal(f)});
    }
  }
  const auto sharp = [&](const AdjacentFace& p) {
    return std::any_of(adjacent_faces_.begin(), adjacent_faces_.end(), [&](const AdjacentFace& q) {
      return p.normal.dot(q.normal) < step.tolerances.sharp_edge_faces;
    });
  };
  return !adjacent_faces_.empty() && !std::all_of(adjacent_faces_.begin(), adjacent_faces_.end(), sharp);
}

/// Does a third body press on a smooth face here as one of the other feature's facets would? Then that facet is flush
/// with what holds the body already. What presses on the far end of the smooth face does not hold it here.
bool VertexVertexSearch::lies_flush(const StepGeometry& step, const Feature& own, const Feature& other) const {
  const double near = step.largest_edge_tolerance(own.body, other.body);
  const auto presses = [&](const Pressure& pressure) {
    if (pressure.by == other.body || !((pressure.place - own.place).norm() < near)) return false;
    return std::any_of(other.faces.begin(), other.faces.end(),
                       [&](const auto& face) { return pressure.normal.dot(face.second) > step.flush_cosine; });
  };
  return std::any_of(own.faces.begin(), own.faces.end(),
                     [&](const auto& face) { return pressures_->any_of(face.first, presses); });
}

/// Bodies whose faces lie in one plane slide past each other there though their corners touch. Where such faces are, a
/// corner is held only if it came from outside of all of them, or was held before. Tells whether it passes instead.
bool VertexVertexSearch::passes(const StepGeometry& step, std::uint64_t key) {
  const double most_cosine = -step.face_face_cosine;
  const Vec3 offset = own_.place - other_.place;
  const Sight* former = former_->find(first_feature(key), [&](const Sight& s) { return s.key == key; });
  const bool known = former != nullptr;
  const Vec3 displacement = known ? Vec3(offset - former->from_feature) : Vec3(Vec3::Zero());
  const double length = displacement.norm(),
               least = step.tolerances.noticeable_motion * step.broad.size(own_.body, other_.body);
  const bool moved = length > least;
  bool flush = false, comes_in = moved;
  for (const auto& [smooth_face, normal] : own_.faces) {
    for (const auto& [across, outward] : other_.faces) {
      if (!(normal.dot(outward) < most_cosine)) continue;
      if (!step.within_edge_tolerance(std::abs(outward.dot(offset)), other_.body, own_.body, outward)) continue;
      flush = true;
      comes_in = comes_in && outward.dot(displacement) < -step.cone_tolerance * length;
    }
  }
  const bool solid = !flush || step.memory.remembers(key) || (known && former->is_solid) || comes_in;
  seen_.push_back({key, known && !moved ? former->from_feature : offset, solid});
  return !solid;
}

/// Whether this is a contact of its own: if another point of these features has its normal, that one is the contact.
/// Those with other normals are dropped for it.
bool VertexVertexSearch::stands_for_others(const StepGeometry& step, const Vec3& normal, bool own_is_first,
                                           FoundPoints& found) const {
  const double same_normal = step.face_face_cosine;
  const double apart = (own_.place - other_.place).norm(), most = step.largest_edge_tolerance(own_.body, other_.body);
  const double near = step.tolerances.same_place * step.broad.size(own_.body, other_.body) + 2 * std::min(apart, most);
  const auto is_of = [](const Feature& feature, int smooth_face) {
    return std::any_of(feature.faces.begin(), feature.faces.end(),
                       [&](const auto& face) { return face.first == smooth_face; });
  };
  const auto has_node = [](const Feature& feature, int node) {
    return node == feature.nodes[0] || node == feature.nodes[1];
  };
  const int first = own_is_first ? 0 : 1;
  const auto rivals = [&](const FoundPoint& q) {
    if (q.dropped || q.kind == PointKind::face_face) return false;
    if ((q.position - own_.place).norm() > near) return false;
    if (q.kind != PointKind::vertex_face) return true;
    const int face_of_other = q.smooth_faces[1 - first], face_of_own = q.smooth_faces[first];
    return (has_node(own_, q.node) && is_of(other_, face_of_other)) ||
           (has_node(other_, q.node) && is_of(own_, face_of_own)) ||
           q.normal.dot(own_is_first ? normal : Vec3(-normal)) > same_normal;
  };
  const auto has_it = [&](const FoundPoint& q) {
    return rivals(q) &&
           (q.kind == PointKind::vertex_vertex || q.normal.dot(own_is_first ? normal : Vec3(-normal)) > same_normal);
  };
  const auto others =
      others_.of(own_is_first ? std::array{own_.body, other_.body} : std::array{other_.body, own_.body});
  const auto before = std::span(found.points).subspan(first_);  // vertex–vertex contacts of these bodies
  if (std::any_of(others.begin(), others.end(), [&](const auto& q) { return has_it(found.points[q.point]); }) ||
      std::any_of(before.begin(), before.end(), has_it))
    return false;
  const auto of_adjacent_faces = [&](const FoundPoint& q) {
    return q.kind == PointKind::face_face &&
           std::any_of(adjacent_faces_.begin(), adjacent_faces_.end(),
                       [&](const AdjacentFace& adjacent) { return adjacent.family == q.family; });
  };
  const auto drop = [&](FoundPoint& q) { q.dropped = q.dropped || rivals(q) || of_adjacent_faces(q); };
  for (const auto& other : others) drop(found.points[other.point]);
  std::for_each(before.begin(), before.end(), drop);
  return true;
}

}  // namespace talus
