#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/units.hpp"
#include "contact/contact_points.hpp"
#include "contact/overlap.hpp"

namespace talus {
namespace {

constexpr double least_area = 1e-14;   // of the size squared: no overlap
constexpr double vertex_snap = 1e-3;   // a corner with this share of a vertex missing is still that vertex's
constexpr double seen_tilt = 1e-9;     // rad between facets: what is less may be rounding
constexpr double seen_spread = 1e-9;   // of a facet's area: what is less may be rounding
constexpr double least_facet = 1e-12;  // of the longest side squared: a needle has no projection

/// A facet in the common plane, counter-clockwise there.
struct Projected {
  Triangle2 points;
  std::array<int, 3> local;  // which node of the facet each point is
  double twice_area = 0;

  Projected(const StepGeometry& step, int facet, const Vec3& origin, const Vec3& e1, const Vec3& e2,
            bool seen_from_behind) {
    const auto& nodes = step.features.facets[facet].nodes;
    local = seen_from_behind ? std::array{2, 1, 0} : std::array{0, 1, 2};
    for (int k = 0; k < 3; ++k) {
      const Vec3 r = step.x[nodes[local[k]]] - origin;
      points[k] = {r.dot(e1), r.dot(e2)};
    }
    twice_area = cross(points[1] - points[0], points[2] - points[0]);
  }
  double side(int k) const { return (points[(k + 2) % 3] - points[(k + 1) % 3]).norm(); }
  bool flat() const { return twice_area > least_facet * std::pow(std::max({side(0), side(1), side(2)}), 2); }
  double share(const Vec2& p, int k) const {
    return cross(points[(k + 1) % 3] - p, points[(k + 2) % 3] - p) / twice_area;
  }
};

/// Area of the finer of two facets over what it was before bodies deformed. Contact is measured by the latter: one that
/// got stiffer because what it presses spreads would hold energy that nobody gave.
double spread(const StepGeometry& step, const FacetPair& pair) {
  const int finer = step.first_areas[pair.a] < step.first_areas[pair.b] ? pair.a : pair.b;
  const double ratio = facet_area(step.features.facets[finer], step.x) / step.first_areas[finer];
  return std::abs(ratio - 1) < seen_spread ? 1 : ratio;
}

/// Directions, in the common plane, in which the convex creases that the whole overlap lies along look out of their
/// facet.
class RimsAlong {
 public:
  RimsAlong(const StepGeometry& step, int facet, int other_body, const Projected& t, const OverlapPolygon& p,
            const Vec3& e1, const Vec3& e2) {
    const ContactFacet& f = step.features.facets[facet];
    const double widest = step.widest_rim(f.body, other_body);
    const auto add_beyond = [&](int beyond, const Vec3& on_crease, const Vec3& inside, double distance) {
      if (step.features.facets[beyond].patch == f.patch || count_ == outward_.size()) return;
      const Vec3 n = step.fresh_normal(beyond);
      if (n.dot(inside - on_crease) < 0 && step.within_rim(distance, f.body, other_body, n))
        outward_[count_++] = Vec2(n.dot(e1), n.dot(e2)).normalized();
    };
    const auto farthest = [&](const auto& distance) {
      double most = 0;
      for (int i = 0; i < p.count; ++i) most = std::max(most, distance(p.corners[i]));
      return most;
    };
    const Vec3 centre = (step.x[f.nodes[0]] + step.x[f.nodes[1]] + step.x[f.nodes[2]]) / 3;
    for (int k = 0; k < 3; ++k) {
      const int node = t.local[k];
      const double height = t.twice_area / t.side(k);
      const double from_edge = farthest([&](const Vec2& c) { return t.share(c, k) * height; });
      const double from_node = farthest([&](const Vec2& c) { return (c - t.points[k]).norm() / tip; });
      if (from_edge < widest) {
        const ContactEdge& e = step.features.edges[f.edges[node]];
        add_beyond(e.facets[0] + e.facets[1] - facet, step.x[e.nodes[0]], centre, from_edge);
      }
      if (!(from_node < widest)) continue;
      for (const int beyond : step.features.facets_at(f.nodes[node]))
        add_beyond(beyond, step.x[f.nodes[node]], centre, from_node);
    }
  }

  bool any() const { return count_ > 0; }
  bool against(const RimsAlong& other) const {
    for (std::size_t i = 0; i < count_; ++i) {
      for (std::size_t j = 0; j < other.count_; ++j) {
        if (outward_[i].dot(other.outward_[j]) < -0.5) return true;
      }
    }
    return false;
  }

 private:
  static constexpr double tip = 3;  // a facet that ends at the crease in a node reaches a little further along it
  std::array<Vec2, 16> outward_;
  std::size_t count_ = 0;
};

}  // namespace

void FacingSearch::find(const StepGeometry& step, std::span<const FacetPair> pairs, FoundPoints& found) {
  corners_.clear();
  const double facing = -std::cos(radians(step.settings.facing_angle));
  for (const FacetPair& pair : pairs) {
    if (step.normals[pair.a].dot(step.normals[pair.b]) < facing) overlap(step, pair, found);
  }
  by_key_.clear();
  for (std::size_t i = 0; i < corners_.size(); ++i) by_key_.emplace_back(corners_[i].key, static_cast<int>(i));
  std::sort(by_key_.begin(), by_key_.end());
  merge(step, found);
}

void FacingSearch::overlap(const StepGeometry& step, const FacetPair& pair, FoundPoints& found) {
  // Both facets are nearly parallel to the common plane: of its four types the two parallel to a facet remain, and the
  // plane halfway between them treats both bodies alike.
  const Vec3 n = (step.normals[pair.b] - step.normals[pair.a]).normalized();
  const Vec3 e1 = n.unitOrthogonal(), e2 = n.cross(e1);
  const ContactFacet &fa = step.features.facets[pair.a], &fb = step.features.facets[pair.b];
  const Vec3& origin = step.x[fa.nodes[0]];
  const Projected a(step, pair.a, origin, e1, e2, true), b(step, pair.b, origin, e1, e2, false);
  if (!a.flat() || !b.flat()) return;
  const OverlapPolygon polygon = talus::overlap(a.points, b.points);
  if (polygon.count == 0) return;
  const double size = step.broad.scale(fa.body, fb.body).size;
  if (!(polygon.area > least_area * size * size)) return;

  const double spread_by = spread(step, pair);
  const std::size_t first = corners_.size(), first_covered = found.covered.size();
  double least_gap = std::numeric_limits<double>::infinity();
  for (int i = 0; i < polygon.count; ++i) {
    if (!(polygon.weights[i] > 0)) continue;  // one of three corners in one place
    Corner c{0, pair, polygon.weights[i] / spread_by, {}, n};
    Vec3 apart = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
      c.shares[a.local[k]] = a.share(polygon.corners[i], k);
      c.shares[3 + b.local[k]] = b.share(polygon.corners[i], k);
    }
    for (int k = 0; k < 3; ++k) {
      apart += c.shares[k] * (step.x[fa.nodes[k]] - origin) - c.shares[3 + k] * (step.x[fb.nodes[k]] - origin);
    }
    least_gap = std::min(least_gap, n.dot(apart));
    name(step, c, found);
    corners_.push_back(c);
  }
  // A strip between a rim of one body and a rim of the other that has just passed it: two bodies lie flush, or one has
  // settled by as much as the strip is wide. It would hold a block that nothing holds.
  const auto between_rims = [&] {
    const RimsAlong rims(step, pair.a, fb.body, a, polygon, e1, e2);
    return rims.any() && rims.against(RimsAlong(step, pair.b, fa.body, b, polygon, e1, e2));
  };
  const auto beside = [&] {
    place_corners(step, first);
    const auto any = [](const Vec3&) { return true; };
    return step.came_past_a_crease(pair.b, places_[0], fa.body, any) ||
           step.came_past_a_crease(pair.a, places_[1], fb.body, any);
  };
  if (least_gap > step.reach || least_gap < -step.depth(fa.body, fb.body) || between_rims() ||
      (least_gap < -step.seen_depth(fa.body, fb.body) && beside())) {
    corners_.resize(first);
    found.covered.resize(first_covered);
  }
}

/// Where the corners from number `first` on lie on each of both bodies.
void FacingSearch::place_corners(const StepGeometry& step, std::size_t first) {
  for (std::vector<Vec3>& places : places_) places.clear();
  for (std::size_t i = first; i < corners_.size(); ++i) {
    const Corner& c = corners_[i];
    Vec3 on_a = Vec3::Zero(), on_b = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
      on_a += c.shares[k] * step.x[step.features.facets[c.facets.a].nodes[k]];
      on_b += c.shares[3 + k] * step.x[step.features.facets[c.facets.b].nodes[k]];
    }
    places_[0].push_back(on_a);
    places_[1].push_back(on_b);
  }
}

/// The features whose meeting the corner is. A vertex that lies amid a facet slides along this one, and so does a
/// crease that crosses an edge of the mesh: by the plane between both they would rise or sink by half the angle between
/// them.
void FacingSearch::name(const StepGeometry& step, Corner& c, FoundPoints& found) {
  const ContactFacet &fa = step.features.facets[c.facets.a], &fb = step.features.facets[c.facets.b];
  const auto a = c.shares.begin(), b = a + 3, end = c.shares.end();
  const auto va = std::max_element(a, b) - a, vb = std::max_element(b, end) - b;
  const bool at_a = a[va] > 1 - vertex_snap, at_b = b[vb] > 1 - vertex_snap;
  const bool tilted = (step.normals[c.facets.a] + step.normals[c.facets.b]).norm() > seen_tilt;
  if (at_a) {
    c.key = vertex_key(fa.nodes[va], fb.patch);
    if (at_b)
      found.covered.push_back({vertex_key(fb.nodes[vb], fa.patch), fb.nodes[vb], c.facets.a, -c.normal});
    else
      c.along = 1;
  } else if (at_b) {
    c.key = vertex_key(fb.nodes[vb], fa.patch);
    c.along = 0;
  } else {
    const auto ea = std::min_element(a, b) - a, eb = std::min_element(b, end) - b;
    c.key = crossing_key(step.features, fa.edges[ea], fa.patch, fb.edges[eb], fb.patch);
    const bool parts_a = step.features.edges[fa.edges[ea]].parts, parts_b = step.features.edges[fb.edges[eb]].parts;
    if (parts_a != parts_b) c.along = parts_a ? 1 : 0;
  }
  if (c.along >= 0 && tilted) c.normal = c.along == 1 ? step.normals[c.facets.b] : Vec3(-step.normals[c.facets.a]);
}

void FacingSearch::merge(const StepGeometry& step, FoundPoints& found) {
  const auto& facets = step.features.facets;
  for (std::size_t i = 0; i < by_key_.size();) {
    FoundPoint p{};
    p.key = by_key_[i].first;
    p.kind = PointKind::facing;
    p.stencil_begin = static_cast<int>(found.nodes.size());
    p.normal = Vec3::Zero();
    std::size_t end = i;
    double heaviest = 0;
    for (; end < by_key_.size() && by_key_[end].first == p.key; ++end) {
      const Corner& c = corners_[by_key_[end].second];
      p.area += c.weight;
      p.normal += c.weight * c.normal;
      if (c.weight > heaviest || end == i) {
        heaviest = c.weight;
        p.along = c.along;
        p.facets = {c.facets.a, c.facets.b};
      }
    }
    int of_first = 0;
    for (int side = 0; side < 2; ++side) {
      const int begin = static_cast<int>(found.nodes.size());
      for (std::size_t j = i; j < end; ++j) {
        const Corner& c = corners_[by_key_[j].second];
        const auto& nodes = facets[side ? c.facets.b : c.facets.a].nodes;
        for (int k = 0; k < 3; ++k) {
          const double weight = (side ? -c.weight : c.weight) * c.shares[3 * side + k] / p.area;
          const auto at = std::find(found.nodes.begin() + begin, found.nodes.end(), nodes[k]);
          if (at != found.nodes.end()) {
            found.weights[at - found.nodes.begin()] += weight;
          } else {
            found.nodes.push_back(nodes[k]);
            found.weights.push_back(weight);
          }
        }
      }
      if (side == 0) of_first = static_cast<int>(found.nodes.size()) - begin;
    }
    p.normal.normalize();
    p.patches = {facets[p.facets[0]].patch, facets[p.facets[1]].patch};
    p.family = patch_family(p.patches[0], p.patches[1]);
    p.node = p.key >> 62 == 1 ? static_cast<int>(p.key >> 31 & 0x7fffffff) : -1;
    p.joint = step.common_joint(p.facets[0], p.facets[1]);
    found.close_stencil(p, step.features, step.x, of_first);
    found.points.push_back(p);
    i = end;
  }
}

}  // namespace talus
