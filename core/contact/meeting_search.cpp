#include "contact/meeting_search.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "base/units.hpp"
#include "contact/cones.hpp"

namespace talus {
namespace {

constexpr double least_roundness = 1e-4, most_roundness = 1e-2, roundness_per_penetration = 3;  // of the size; –
constexpr double deepest_core = 10;          // roundnesses below the tip of a needle
constexpr double least_core_distance = 0.1;  // of the roundness: where cores meet there is no direction between them
constexpr double same_place = 1e-3;          // of the size: two contacts there with one normal are one
constexpr double seen_to_move = 1e-7;        // of the size: a way that tells a direction
constexpr std::size_t most_faces = 16;       // around a corner, mostly
constexpr double sharp_ridge = -0.2;         // cosine between the normals of the flanks of a ridge, at most
constexpr int corner_bit = 1 << 30;          // of a key: a corner's node, else a crease

bool is_convex(const StepGeometry& step, const ContactEdge& e) {
  return step.fresh_normal(e.facets[0]).dot(step.x[e.opposite[1]] - step.x[e.nodes[0]]) < 0;
}

/// The way from a node to its core, for a roundness of 1: all facets around, moved inwards by 1, meet there as nearly
/// as they can.
Vec3 towards_core(const StepGeometry& step, int node) {
  constexpr double regular = 1e-9;  // along a crease every place is as good
  Mat3 matrix = regular * Mat3::Identity();
  Vec3 right = Vec3::Zero();
  for (const int facet : step.features.facets_at(node)) {
    const Vec3 n = step.fresh_normal(facet);
    matrix += n * n.transpose();
    right -= n;
  }
  const Vec3 way = matrix.inverse() * right;
  return way.norm() > deepest_core ? Vec3(way * (deepest_core / way.norm())) : way;
}

double roundness(const StepGeometry& step, int body_a, int body_b) {
  const double size = step.broad.scale(body_a, body_b).size;
  return std::clamp(roundness_per_penetration * step.deepest(body_a, body_b), least_roundness * size,
                    most_roundness * size);
}

std::uint64_t meeting_key(int node, int other) {
  return static_cast<std::uint64_t>(node) << 31 | static_cast<std::uint64_t>(other);
}

void add_faces(const StepGeometry& step, std::span<const int> facets, std::vector<std::pair<int, Vec3>>& faces) {
  for (const int facet : facets) {
    const int patch = step.features.facets[facet].patch;
    const auto known = [&](const auto& face) { return face.first == patch; };
    if (std::none_of(faces.begin(), faces.end(), known)) faces.emplace_back(patch, step.fresh_normal(facet));
  }
}

int body_of(const StepGeometry& step, int node) { return step.features.facets[step.features.facets_at(node)[0]].body; }

}  // namespace

MeetingSearch::MeetingSearch() {
  own_.faces.reserve(most_faces);
  other_.faces.reserve(most_faces);
}

void MeetingSearch::find(const StepGeometry& step, std::span<const FacetPair> pairs,
                         const std::function<bool(std::uint64_t)>& remembered, FoundPoints& found) {
  meetings_.clear();
  seen_.clear();
  list_facing(found);
  const ContactFeatures& features = step.features;
  const auto corner = [&](const ContactFacet& f, int k) { return f.owns_node[k] && features.corner[f.nodes[k]]; };
  const auto crease = [&](const ContactFacet& f, int k) { return f.owns_edge[k] && features.edges[f.edges[k]].parts; };
  const auto meet_all = [&](const ContactFacet& with_corners, const ContactFacet& with_creases, bool is_first) {
    for (int i = 0; i < 3; ++i) {
      if (!corner(with_corners, i)) continue;
      for (int j = 0; j < 3; ++j)
        if (crease(with_creases, j)) meet(step, with_corners.nodes[i], with_creases.edges[j], is_first);
    }
  };
  for (const FacetPair& pair : pairs) {
    const ContactFacet &a = features.facets[pair.a], &b = features.facets[pair.b];
    meet_all(a, b, true);
    meet_all(b, a, false);
    for (int i = 0; i < 3; ++i) {
      if (!crease(a, i)) continue;
      for (int j = 0; j < 3; ++j)
        if (crease(b, j)) meet_across(step, a.edges[i], b.edges[j]);
    }
  }
  if (meetings_.empty()) return;
  std::sort(meetings_.begin(), meetings_.end(), [](const Encounter& p, const Encounter& q) {
    return p.key != q.key ? p.key < q.key : p.apart != q.apart ? p.apart < q.apart : p.other.edge < q.other.edge;
  });
  list_pressures(step, found);
  for (std::size_t i = 0; i < meetings_.size(); ++i)
    if (i == 0 || meetings_[i].key != meetings_[i - 1].key) add(step, meetings_[i], remembered, found);
}

/// A corner and an edge that may be near each other.
void MeetingSearch::meet(const StepGeometry& step, int node, int edge, bool node_is_first) {
  const ContactFeatures& features = step.features;
  const ContactEdge& e = features.edges[edge];
  const Vec3 &v = step.x[node], &p = step.x[e.nodes[0]], along = step.x[e.nodes[1]] - p;
  const int own = body_of(step, node), other = features.facets[e.facets[0]].body;
  const double r = roundness(step, own, other), far = step.reach + 3 * deepest_core * r;
  const double nearest = std::clamp((v - p).dot(along) / along.squaredNorm(), 0.0, 1.0);
  if (!((v - p - nearest * along).squaredNorm() < far * far) || !is_convex(step, e)) return;
  if (facing_have_it(step, features.facets_at(node), e.facets, node_is_first)) return;

  const Vec3 core = v + r * towards_core(step, node);
  const Vec3 from = p + r * towards_core(step, e.nodes[0]);
  const Vec3 core_along = step.x[e.nodes[1]] + r * towards_core(step, e.nodes[1]) - from;
  const double share = std::clamp((core - from).dot(core_along) / core_along.squaredNorm(), 0.0, 1.0);
  const double apart = (core - from - share * core_along).norm();
  const int end = share == 0 ? e.nodes[0] : share == 1 ? e.nodes[1] : -1;
  if (end < 0 || !features.corner[end]) {
    meetings_.push_back({meeting_key(node, e.crease), {node, -1, 0}, {-1, edge, share}, apart, node_is_first});
  } else {  // of two corners the first body's comes first
    const int first = node_is_first ? node : end, second = node_is_first ? end : node;
    meetings_.push_back({meeting_key(first, corner_bit | second), {first, -1, 0}, {second, -1, 0}, apart, true});
  }
}

/// Two edges that cross at an angle so small that which way their normal points hangs by a hair; but where their ends
/// part by less than the rim, these hold them.
void MeetingSearch::meet_across(const StepGeometry& step, int edge_a, int edge_b) {
  const ContactFeatures& features = step.features;
  const ContactEdge &a = features.edges[edge_a], &b = features.edges[edge_b];
  const Vec3 u = step.x[a.nodes[1]] - step.x[a.nodes[0]], w = step.x[b.nodes[1]] - step.x[b.nodes[0]];
  const double uu = u.squaredNorm(), ww = w.squaredNorm(), squared = u.cross(w).squaredNorm();
  if (squared > nearly_parallel * uu * ww) return;
  const int own = features.facets[a.facets[0]].body, other = features.facets[b.facets[0]].body;
  const double rim = step.rim(own, other);
  if (!(squared > rim * rim * std::max(uu, ww)) || !is_convex(step, a) || !is_convex(step, b)) return;
  if (facing_have_it(step, a.facets, b.facets, true)) return;

  const double r = roundness(step, own, other);
  const auto core = [&](int node) { return Vec3(step.x[node] + r * towards_core(step, node)); };
  const Vec3 p = core(a.nodes[0]), along_a = core(a.nodes[1]) - p;
  const Vec3 q = core(b.nodes[0]), along_b = core(b.nodes[1]) - q;
  const Vec3 across = along_a.cross(along_b), between = q - p;
  const double s = between.cross(along_b).dot(across) / across.squaredNorm();
  const double t = between.cross(along_a).dot(across) / across.squaredNorm();
  if (!(s > 0 && s < 1 && t > 0 && t < 1)) return;
  const double apart = (between + t * along_b - s * along_a).norm();
  meetings_.push_back({edge_key(edge_a, edge_b), {-1, edge_a, s}, {-1, edge_b, t}, apart, true});
}

void MeetingSearch::list_facing(const FoundPoints& found) {
  facing_.clear();
  for (const FoundPoint& p : found.points) {
    if (p.kind == PointKind::facing && (facing_.empty() || facing_.back() != p.family)) facing_.push_back(p.family);
  }
  std::sort(facing_.begin(), facing_.end());
  facing_.erase(std::unique(facing_.begin(), facing_.end()), facing_.end());
}

void MeetingSearch::list_pressures(const StepGeometry& step, const FoundPoints& found) {
  pressures_.clear();
  for (const FoundPoint& p : found.points) {
    if (p.dropped || p.gap > step.reach) continue;
    if (p.patches[0] >= 0) pressures_.push_back({p.patches[0], p.bodies[1], p.normal, p.position});
    if (p.patches[1] >= 0) pressures_.push_back({p.patches[1], p.bodies[0], -p.normal, p.position});
  }
  std::sort(pressures_.begin(), pressures_.end());
}

std::span<const int> MeetingSearch::facets_at(const ContactFeatures& features, const Place& place) {
  if (place.node >= 0) return features.facets_at(place.node);
  return features.edges[place.edge].facets;
}

std::array<int, 2> MeetingSearch::ends_of(const ContactFeatures& features, const Place& place) {
  return place.node >= 0 ? std::array{place.node, place.node} : features.edges[place.edge].nodes;
}

/// Whether a direction from the other body into this one is opposite to one of the feature's normal cone.
bool MeetingSearch::in_cone(const StepGeometry& step, const Place& place, const Vec3& inwards) {
  const double tolerance = cone_tolerance(step.settings);
  if (place.node >= 0) return rise(step, place.node, inwards) >= -tolerance;
  const auto into = into_facets(step, step.features.edges[place.edge]);
  return into[0].dot(inwards) >= -tolerance && into[1].dot(inwards) >= -tolerance;
}

void MeetingSearch::take(const StepGeometry& step, const Place& place, double r, double rim, Feature& feature) {
  const auto ends = ends_of(step.features, place);
  const auto facets = facets_at(step.features, place);
  const auto core = [&](int node) { return Vec3(step.x[node] + r * towards_core(step, node)); };
  feature.body = step.features.facets[facets[0]].body;
  feature.place = step.x[ends[0]] + place.share * (step.x[ends[1]] - step.x[ends[0]]);
  feature.core = core(ends[0]) + place.share * (core(ends[1]) - core(ends[0]));
  feature.nodes = {-1, -1};
  feature.faces.clear();
  add_faces(step, facets, feature.faces);
  for (int k = 0; k < 2; ++k) {
    if ((step.x[ends[k]] - feature.place).norm() > rim) continue;
    feature.nodes[k] = ends[k];
    add_faces(step, step.features.facets_at(ends[k]), feature.faces);
  }
}

void MeetingSearch::add(const StepGeometry& step, const Encounter& m,
                        const std::function<bool(std::uint64_t)>& remembered, FoundPoints& found) {
  const ContactFeatures& features = step.features;
  const auto own_facets = facets_at(features, m.own), other_facets = facets_at(features, m.other);
  if (facing_have_it(step, own_facets, other_facets, m.own_is_first)) return;
  const int own = features.facets[own_facets[0]].body, other = features.facets[other_facets[0]].body;
  const double r = roundness(step, own, other), rim = step.rim(own, other);
  take(step, m.own, r, rim, own_);
  take(step, m.other, r, rim, other_);
  const std::optional<Vec3> normal = normal_of(step, m, r);
  if (!normal) return;
  const Vec3& n = *normal;
  const double gap = n.dot(own_.place - other_.place);
  if (!(gap <= step.reach) || gap < -step.depth(own, other)) return;
  if (lies_flush(step, own_, other_) || lies_flush(step, other_, own_)) return;
  if (passes(step, m.key, remembered(m.key))) return;
  if (!stands_for_others(step, n, m.own_is_first, found)) return;

  FoundPoint p{};
  p.key = m.key;
  p.family = m.key;
  p.kind = PointKind::meeting;
  p.facets = {own_facets[0], other_facets[0]};
  p.patches = {-1, -1};
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
  found.add_between(p, ends_of(features, first), first.share, ends_of(features, second), second.share, features,
                    step.x);
}

/// Two features are nearest each other where the direction between them lies in the normal cones of both. That of
/// edges that cross is the one across both: between cores that have passed each other it would point the wrong way.
std::optional<Vec3> MeetingSearch::normal_of(const StepGeometry& step, const Encounter& m, double roundness) const {
  const auto fits = [&](const Vec3& n) { return in_cone(step, m.own, n) && in_cone(step, m.other, -n); };
  Vec3 n = (own_.core - other_.core) / m.apart;
  if (m.own.node < 0 && m.other.node < 0) {
    const auto along = [&](const Place& place) {
      const auto& nodes = step.features.edges[place.edge].nodes;
      return Vec3(step.x[nodes[1]] - step.x[nodes[0]]);
    };
    n = along(m.own).cross(along(m.other)).normalized();
    if (!fits(n)) n = -n;
  } else if (!(m.apart > least_core_distance * roundness)) {
    return std::nullopt;
  }
  return fits(n) ? std::optional(n) : std::nullopt;
}

/// Where patches around both features face each other and overlap, these points hold the place too. But a sharp corner
/// that has sunk into a sharp ridge overlaps it on both flanks: what faces each other there are its far sides, which
/// push against each other and hardly up.
bool MeetingSearch::facing_have_it(const StepGeometry& step, std::span<const int> facets, std::span<const int> others,
                                   bool are_first) {
  if (facing_.empty()) return false;
  flanks_.clear();
  for (const int f : facets) {
    for (const int g : others) {
      const int a = step.features.facets[f].patch, b = step.features.facets[g].patch;
      const std::uint64_t family = are_first ? patch_family(a, b) : patch_family(b, a);
      if (std::binary_search(facing_.begin(), facing_.end(), family)) flanks_.push_back({family, step.fresh_normal(f)});
    }
  }
  const auto sharp = [&](const Flank& p) {
    return std::any_of(flanks_.begin(), flanks_.end(),
                       [&](const Flank& q) { return p.normal.dot(q.normal) < sharp_ridge; });
  };
  return !flanks_.empty() && !std::all_of(flanks_.begin(), flanks_.end(), sharp);
}

/// Does a third body press on a patch here as one of the other feature's facets would? Then that one only goes on what
/// holds the body already. What presses on the far end of the patch does not hold this one.
bool MeetingSearch::lies_flush(const StepGeometry& step, const Feature& own, const Feature& other) const {
  const double flush = std::cos(radians(flush_angle)), near = step.widest_rim(own.body, other.body);
  for (const auto& [patch, ignored] : own.faces) {
    const auto [begin, end] = std::equal_range(pressures_.begin(), pressures_.end(), Pressure{patch, 0, {}, {}});
    for (auto it = begin; it != end; ++it) {
      if (it->by == other.body || !((it->place - own.place).norm() < near)) continue;
      for (const auto& [beyond, normal] : other.faces)
        if (it->normal.dot(normal) > flush) return true;
    }
  }
  return false;
}

/// Bodies whose faces lie in one plane slide past each other there though their corners meet. Where such faces are, a
/// corner must have come from outside of all of them, or been there already, to be held.
bool MeetingSearch::passes(const StepGeometry& step, std::uint64_t key, bool remembered) {
  const double facing = -std::cos(radians(step.settings.facing_angle));
  const Vec3 offset = own_.place - other_.place;
  const auto former =
      std::lower_bound(former_.begin(), former_.end(), key, [](const Sight& s, std::uint64_t k) { return s.key < k; });
  const bool known = former != former_.end() && former->key == key;
  const Vec3 way = known ? Vec3(offset - former->from_feature) : Vec3(Vec3::Zero());
  const double length = way.norm(), least = seen_to_move * step.broad.scale(own_.body, other_.body).size;
  const bool moved = length > least;
  bool flush = false, comes_in = moved;
  for (const auto& [patch, normal] : own_.faces) {
    for (const auto& [beyond, outward] : other_.faces) {
      if (!(normal.dot(outward) < facing)) continue;
      if (!step.within_rim(std::abs(outward.dot(offset)), other_.body, own_.body, outward)) continue;
      flush = true;
      comes_in = comes_in && outward.dot(way) < -cone_tolerance(step.settings) * length;
    }
  }
  const bool solid = !flush || remembered || (known && former->is_solid) || comes_in;
  seen_.push_back({key, known && !moved ? former->from_feature : offset, solid});
  return !solid;
}

/// Whether the meeting is a contact of its own: if another point of these features has its normal, that one is the
/// contact. Those with other normals make way for it.
bool MeetingSearch::stands_for_others(const StepGeometry& step, const Vec3& normal, bool own_is_first,
                                      FoundPoints& found) const {
  const double same_normal = std::cos(radians(step.settings.facing_angle));
  const double near =
      same_place * step.broad.scale(own_.body, other_.body).size + 2 * (own_.place - other_.place).norm();
  const auto is_of = [](const Feature& feature, int patch) {
    return std::any_of(feature.faces.begin(), feature.faces.end(),
                       [&](const auto& face) { return face.first == patch; });
  };
  const auto has_node = [](const Feature& feature, int node) {
    return node == feature.nodes[0] || node == feature.nodes[1];
  };
  const auto rivals = [&](const FoundPoint& q) {
    if (q.dropped || q.kind == PointKind::facing) return false;
    const int first = own_is_first ? 0 : 1;
    if (q.bodies[first] != own_.body || q.bodies[1 - first] != other_.body) return false;
    if ((q.position - own_.place).norm() > near) return false;
    if (q.kind != PointKind::vertex) return true;
    const int patch_of_other = q.patches[1 - first], patch_of_own = q.patches[first];
    return (has_node(own_, q.node) && is_of(other_, patch_of_other)) ||
           (has_node(other_, q.node) && is_of(own_, patch_of_own)) ||
           q.normal.dot(own_is_first ? normal : Vec3(-normal)) > same_normal;
  };
  for (const FoundPoint& q : found.points) {
    if (rivals(q) && q.normal.dot(own_is_first ? normal : Vec3(-normal)) > same_normal) return false;
    if (q.kind == PointKind::meeting && rivals(q)) return false;
  }
  const auto faces = [&](const FoundPoint& q) {
    return q.kind == PointKind::facing &&
           std::any_of(flanks_.begin(), flanks_.end(), [&](const Flank& flank) { return flank.family == q.family; });
  };
  for (FoundPoint& q : found.points) q.dropped = q.dropped || rivals(q) || faces(q);
  return true;
}

}  // namespace talus
