#include "contact/narrow/face_face_search.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/narrow/polygon_overlap.hpp"

namespace talus {
namespace {

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
  bool has_area(double least) const { return twice_area > least * std::pow(std::max({side(0), side(1), side(2)}), 2); }
  double barycentric(const Vec2& p, int k) const {
    return cross(points[(k + 1) % 3] - p, points[(k + 2) % 3] - p) / twice_area;
  }
};

/// Area of the finer of two facets over what it was before bodies deformed. Contact is measured by the latter: one that
/// got stiffer because what it presses spreads would hold energy that nobody gave.
double spread(const StepGeometry& step, const FacetPair& pair) {
  const int finer = step.first_areas[pair.a] < step.first_areas[pair.b] ? pair.a : pair.b;
  const double ratio = facet_area(step.features.facets[finer], step.x) / step.first_areas[finer];
  return std::abs(ratio - 1) < step.tolerances.noticeable_spread ? 1 : ratio;
}

/// The convex sharp edges of a facet that a whole overlap lies along: the directions, in the common plane, in which
/// they look out of the facet.
class SharpEdgesAlong {
 public:
  SharpEdgesAlong(const StepGeometry& step, int facet, int other_body, const Projected& t, const OverlapPolygon& p,
                  const Vec3& e1, const Vec3& e2) {
    const ContactFacet& f = step.features.facets[facet];
    const double widest = step.largest_edge_tolerance(f.body, other_body);
    const auto add_across = [&](int across, const Vec3& on_edge, const Vec3& inside, double distance) {
      if (step.features.facets[across].smooth_face == f.smooth_face) return;
      const Vec3& n = step.normal(across);
      const bool convex = n.dot(inside - on_edge) < 0;
      if (!convex || !step.within_edge_tolerance(distance, f.body, other_body, n)) return;
      if (count_ < outward_.size())
        outward_[count_++] = Vec2(n.dot(e1), n.dot(e2)).normalized();
      else
        step.count(step.work.edges_left_out);
    };
    const auto farthest = [&](const auto& distance) {
      double most = 0;
      for (int i = 0; i < p.count; ++i) most = std::max(most, distance(p.corners[i]));
      return most;
    };
    const Vec3 centre = step.centre(facet);
    for (int k = 0; k < 3; ++k) {
      const int node = t.local[k];
      const double height = t.twice_area / t.side(k);
      const double from_edge = farthest([&](const Vec2& c) { return t.barycentric(c, k) * height; });
      const double from_node =
          farthest([&](const Vec2& c) { return (c - t.points[k]).norm() / step.tolerances.beside_edge_at_node; });
      if (from_edge < widest) {
        const ContactEdge& e = step.features.edges[f.edges[node]];
        add_across(e.facets[0] + e.facets[1] - facet, step.x[e.nodes[0]], centre, from_edge);
      }
      if (!(from_node < widest)) continue;
      for (const int across : step.features.facets_at(f.nodes[node]))
        add_across(across, step.x[f.nodes[node]], centre, from_node);
    }
  }

  bool any() const { return count_ > 0; }
  bool opposite_to(const SharpEdgesAlong& other, double opposite_edges) const {
    for (std::size_t i = 0; i < count_; ++i) {
      for (std::size_t j = 0; j < other.count_; ++j) {
        if (outward_[i].dot(other.outward_[j]) < opposite_edges) return true;
      }
    }
    return false;
  }

 private:
  std::array<Vec2, 16> outward_;
  std::size_t count_ = 0;
};

}  // namespace

void FaceFaceSearch::find(const StepGeometry& step, std::span<const FacetPair> pairs, FoundPoints& found) {
  corners_.clear();
  const double most_cosine = -step.face_face_cosine();
  for (const FacetPair& pair : pairs) {
    if (step.normal(pair.a).dot(step.normal(pair.b)) < most_cosine) overlap(step, pair, found);
  }
  by_key_.clear();
  for (std::size_t i = 0; i < corners_.size(); ++i) by_key_.emplace_back(corners_[i].key, static_cast<int>(i));
  std::sort(by_key_.begin(), by_key_.end());
  merge(step, found);
}

void FaceFaceSearch::overlap(const StepGeometry& step, const FacetPair& pair, FoundPoints& found) {
  // Both facets are nearly parallel to the common plane: of its four types the two parallel to a facet remain, and the
  // plane halfway between them treats both bodies alike.
  const Vec3 n = (step.normal(pair.b) - step.normal(pair.a)).normalized();
  const Vec3 e1 = n.unitOrthogonal(), e2 = n.cross(e1);
  const ContactFacet &fa = step.features.facets[pair.a], &fb = step.features.facets[pair.b];
  const Vec3& origin = step.x[fa.nodes[0]];
  const Projected a(step, pair.a, origin, e1, e2, true), b(step, pair.b, origin, e1, e2, false);
  const double least_facet = step.tolerances.least_facet_area;
  if (!a.has_area(least_facet) || !b.has_area(least_facet)) return;
  const OverlapPolygon polygon = talus::overlap(a.points, b.points, step.tolerances);
  if (polygon.count == 0) return;
  const double size = step.broad.size(fa.body, fb.body);
  if (!(polygon.area > step.tolerances.least_overlap_area * size * size)) return;

  const double spread_by = spread(step, pair);
  const std::size_t first = corners_.size(), first_covered = found.covered.size();
  double least_gap = std::numeric_limits<double>::infinity();
  for (int i = 0; i < polygon.count; ++i) {
    if (!(polygon.weights[i] > 0)) continue;  // one of three corners in one place
    Corner c{0, pair, polygon.weights[i] / spread_by, {}, n};
    Vec3 apart = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
      c.at[a.local[k]] = a.barycentric(polygon.corners[i], k);
      c.at[3 + b.local[k]] = b.barycentric(polygon.corners[i], k);
    }
    for (int k = 0; k < 3; ++k) {
      apart += c.at[k] * (step.x[fa.nodes[k]] - origin) - c.at[3 + k] * (step.x[fb.nodes[k]] - origin);
    }
    least_gap = std::min(least_gap, n.dot(apart));
    name(step, c, found);
    corners_.push_back(c);
  }
  // A strip between a sharp edge of one body and one of the other that has just passed it: two bodies lie flush, or one
  // has sunk by as much as the strip is wide. It would hold a block that nothing holds.
  const auto between_sharp_edges = [&] {
    const SharpEdgesAlong sharp_edges(step, pair.a, fb.body, a, polygon, e1, e2);
    return sharp_edges.any() && sharp_edges.opposite_to(SharpEdgesAlong(step, pair.b, fa.body, b, polygon, e1, e2),
                                                        step.tolerances.opposite_edges);
  };
  const auto beside = [&] {
    place_corners(step, first);
    const auto any = [](const Vec3&) { return true; };
    return step.came_past_sharp_edge(pair.b, places_[0], fa.body, any) ||
           step.came_past_sharp_edge(pair.a, places_[1], fb.body, any);
  };
  if (least_gap > step.reach || least_gap < -step.depth(fa.body, fb.body) || between_sharp_edges() ||
      (least_gap < -step.noticeable_depth(fa.body, fb.body) && beside())) {
    corners_.resize(first);
    found.covered.resize(first_covered);
  }
}

/// Where the corners from number `first` on lie on each of both bodies.
void FaceFaceSearch::place_corners(const StepGeometry& step, std::size_t first) {
  for (std::vector<Vec3>& places : places_) places.clear();
  for (std::size_t i = first; i < corners_.size(); ++i) {
    const Corner& c = corners_[i];
    Vec3 on_a = Vec3::Zero(), on_b = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
      on_a += c.at[k] * step.x[step.features.facets[c.facets.a].nodes[k]];
      on_b += c.at[3 + k] * step.x[step.features.facets[c.facets.b].nodes[k]];
    }
    places_[0].push_back(on_a);
    places_[1].push_back(on_b);
  }
}

/// Which features cross at the corner. A vertex that lies amid a facet slides along it, and so does a sharp edge that
/// crosses an edge of the mesh: along the plane halfway they would rise or sink by half the angle between both facets.
void FaceFaceSearch::name(const StepGeometry& step, Corner& c, FoundPoints& found) {
  const ContactFacet &fa = step.features.facets[c.facets.a], &fb = step.features.facets[c.facets.b];
  const auto a = c.at.begin(), b = a + 3, end = c.at.end();
  const auto va = std::max_element(a, b) - a, vb = std::max_element(b, end) - b;
  const double at_vertex = 1 - step.tolerances.at_vertex;
  const bool at_a = a[va] > at_vertex, at_b = b[vb] > at_vertex;
  const bool tilted = (step.normal(c.facets.a) + step.normal(c.facets.b)).norm() > step.tolerances.noticeable_tilt;
  if (at_a) {
    c.key = vertex_key(fa.nodes[va], fb.smooth_face);
    if (at_b)
      found.covered.push_back({vertex_key(fb.nodes[vb], fa.smooth_face), fb.nodes[vb], c.facets.a, -c.normal});
    else
      c.along = 1;
  } else if (at_b) {
    c.key = vertex_key(fb.nodes[vb], fa.smooth_face);
    c.along = 0;
  } else {
    const auto ea = std::min_element(a, b) - a, eb = std::min_element(b, end) - b;
    c.key = crossing_key(step.features, fa.edges[ea], fa.smooth_face, fb.edges[eb], fb.smooth_face);
    const bool sharp_a = step.features.edges[fa.edges[ea]].is_sharp,
               sharp_b = step.features.edges[fb.edges[eb]].is_sharp;
    if (sharp_a != sharp_b) c.along = sharp_a ? 1 : 0;
  }
  if (c.along >= 0 && tilted) c.normal = c.along == 1 ? step.normal(c.facets.b) : Vec3(-step.normal(c.facets.a));
}

void FaceFaceSearch::merge(const StepGeometry& step, FoundPoints& found) {
  const auto& facets = step.features.facets;
  for (std::size_t i = 0; i < by_key_.size();) {
    FoundPoint p{};
    p.key = by_key_[i].first;
    p.kind = PointKind::face_face;
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
          const double weight = (side ? -c.weight : c.weight) * c.at[3 * side + k] / p.area;
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
    p.smooth_faces = {facets[p.facets[0]].smooth_face, facets[p.facets[1]].smooth_face};
    p.family = face_family(p.smooth_faces[0], p.smooth_faces[1]);
    p.node = p.key >> 62 == 1 ? static_cast<int>(p.key >> 31 & 0x7fffffff) : -1;
    p.joint = step.common_joint(p.facets[0], p.facets[1]);
    found.close_stencil(p, step.features, step.x, of_first);
    found.points.push_back(p);
    i = end;
  }
}

}  // namespace talus
