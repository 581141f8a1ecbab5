#include "contact/narrow/face_face_search.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "contact/narrow/normal_cones.hpp"
#include "contact/narrow/polygon_overlap.hpp"

namespace talus {
namespace {

/// Area of the finer of two faces over what it was before bodies deformed. Contact is measured by the latter: one that
/// got stiffer because what it presses spreads would hold energy that nobody gave.
double spread(const StepGeometry& step, const FacePair& pair) {
  const int a = step.features.faces[pair.a].facet, b = step.features.faces[pair.b].facet;
  const int finer = step.first_areas[a] < step.first_areas[b] ? a : b;
  const double ratio = facet_area(step.features.facets[finer], step.x) / step.first_areas[finer];
  return std::abs(ratio - 1) < step.tolerances.noticeable_spread ? 1 : ratio;
}

/// The convex sharp edges of a face that a whole overlap lies along: the directions, in the common plane, in which they
/// look out of the face.
class SharpEdgesAlong {
 public:
  SharpEdgesAlong(const StepGeometry& step, int face, int other_body, const ProjectedFace& flat,
                  const OverlapPolygon& p, const Vec3& e1, const Vec3& e2) {
    const ContactFeatures& features = step.features;
    const ContactFace& f = features.faces[face];
    const double widest = step.largest_edge_tolerance(f.body, other_body);
    const Vec3 centre = step.centre(face);
    const auto add_across = [&](int across, const Vec3& on_edge, double distance) {
      if (features.facets[across].smooth_face == f.smooth_face) return;
      const Vec3& n = step.normal(across);
      const bool convex = n.dot(centre - on_edge) < 0;
      if (!convex || !step.within_edge_tolerance(distance, f.body, other_body, n)) return;
      if (count_ < outward_.size())
        outward_[count_++] = Vec2(n.dot(e1), n.dot(e2)).normalized();
      else
        step.count(step.work.edges_left_out);
    };
    const auto farthest = [&](const auto& distance) {  // or some distance that is too far
      double most = 0;
      for (const Vec2& corner : p.corners)
        if (most = std::max(most, distance(corner)); !(most < widest)) break;
      return most;
    };
    for (std::size_t k = 0; k < flat.points.size(); ++k) {
      const double from_side = farthest([&](const Vec2& c) { return flat.distance(c, k); });
      const double from_node =
          farthest([&](const Vec2& c) { return (c - flat.points[k]).norm() / step.tolerances.beside_edge_at_node; });
      if (from_side < widest) {
        const int edge = flat.sides[k];
        add_across(features.across(edge, face), step.x[features.edges[edge].nodes[0]], from_side);
      }
      if (!(from_node < widest)) continue;
      for (const int across : features.facets_at(flat.nodes[k])) add_across(across, step.x[flat.nodes[k]], from_node);
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

/// The direction across two convex edges of which each may touch the other along it, to the side of `normal`.
std::optional<Vec3> normal_across(const StepGeometry& step, int edge_a, int edge_b, const Vec3& normal) {
  const FeatureShapes::Edge &a = step.shapes.edge(edge_a), &b = step.shapes.edge(edge_b);
  const Vec3 across = a.along.cross(b.along);
  if (!a.is_convex || !b.is_convex || !(across.squaredNorm() > step.tolerances.parallel_edges)) return std::nullopt;
  const Vec3 n = (normal.dot(across) < 0 ? -1 : 1) * across.normalized();
  if (!is_in_cone(step, a, n) || !is_in_cone(step, b, -n)) return std::nullopt;
  return n;
}

}  // namespace

void ProjectedFace::project(const StepGeometry& step, int face, const FlatPlane& plane, bool seen_from_behind) {
  const auto outline = step.features.outline(face), edges = step.features.sides(face);
  const std::size_t count = outline.size();
  points.resize(count);
  nodes.resize(count);
  sides.resize(count);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t at = seen_from_behind ? count - 1 - k : k;
    nodes[k] = outline[at];
    sides[k] = edges[seen_from_behind ? (at + count - 1) % count : at];
    points[k] = plane.at(step.x[nodes[k]]);
  }
  facets.clear();
}

void ProjectedFace::measure_sides() {
  const std::size_t count = points.size();
  lengths.resize(count);
  for (std::size_t k = 0; k < count; ++k) lengths[k] = (points[(k + 1) % count] - points[k]).norm();
}

bool ProjectedFace::has_area(double least) const {
  double twice_area = 0, longest = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Vec2 &p = points[k], &next = points[(k + 1) % points.size()];
    twice_area += cross(p - points[0], next - points[0]);
    longest = std::max(longest, (next - p).squaredNorm());
  }
  return twice_area > least * longest;
}

double ProjectedFace::most_overlap(const ProjectedFace& other) const {
  const auto box_of = [](const ProjectedFace& face) {
    Eigen::AlignedBox2d box;
    for (const Vec2& p : face.points) box.extend(p);
    return box;
  };
  const Vec2 sides = box_of(*this).intersection(box_of(other)).sizes();
  return sides.minCoeff() > 0 ? sides.prod() : 0;
}

double ProjectedFace::distance(const Vec2& p, std::size_t side) const {
  const Vec2 &from = points[side], along = points[(side + 1) % points.size()] - from;
  return cross(along, p - from) / lengths[side];
}

int ProjectedFace::node_at(const Vec2& p, double at_vertex) const {
  const std::size_t count = points.size();
  double least = at_vertex;
  int node = -1;
  for (std::size_t k = 0; k < count; ++k) {
    const double shorter = std::min(lengths[(k + count - 1) % count], lengths[k]);
    const double squared = (p - points[k]).squaredNorm();
    if (squared > 2 * at_vertex * at_vertex * shorter * shorter) continue;  // clearly
    const double apart = std::sqrt(squared) / shorter;
    if (apart < least) least = apart, node = nodes[k];
  }
  return node;
}

int ProjectedFace::nearest_side(const Vec2& p) const {
  int nearest = -1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Vec2 &from = points[k], along = points[(k + 1) % points.size()] - from;
    const Vec2 beside = p - from - along * std::clamp(along.dot(p - from) / along.squaredNorm(), 0.0, 1.0);
    if (beside.squaredNorm() < least) least = beside.squaredNorm(), nearest = sides[k];
  }
  return nearest;
}

void ProjectedFace::project_facets(const StepGeometry& step, int face, const FlatPlane& plane) {
  for (const int number : step.features.facets_of(face)) {
    const auto& n = step.features.facets[number].nodes;
    facets.push_back({number, {plane.at(step.x[n[0]]), plane.at(step.x[n[1]]), plane.at(step.x[n[2]])}});
  }
}

int ProjectedFace::locate(const Vec2& p, double* at) const {
  int facet = -1;
  double most = -std::numeric_limits<double>::infinity();
  for (const FlatFacet& f : facets) {
    const auto& q = f.points;
    const double twice_area = cross(q[1] - q[0], q[2] - q[0]);
    const std::array<double, 3> here = {cross(q[1] - p, q[2] - p) / twice_area, cross(q[2] - p, q[0] - p) / twice_area,
                                        cross(q[0] - p, q[1] - p) / twice_area};
    const double inside = std::min({here[0], here[1], here[2]});
    if (!(inside > most)) continue;
    most = inside;
    facet = f.facet;
    std::copy(here.begin(), here.end(), at);
  }
  return facet;
}

void FaceFaceSearch::find(const StepGeometry& step, std::span<const FacePair> facing, SeparatingAxis& axis,
                          FoundPoints& found) {
  corners_.clear();
  for (const FacePair& pair : facing) overlap(step, pair, axis, found);
  by_key_.clear();
  for (std::size_t i = 0; i < corners_.size(); ++i) by_key_.emplace_back(corners_[i].key, static_cast<int>(i));
  std::sort(by_key_.begin(), by_key_.end());
  merge(step, found);
}

void FaceFaceSearch::overlap(const StepGeometry& step, const FacePair& pair, SeparatingAxis& axis, FoundPoints& found) {
  // Both faces are nearly parallel to the common plane: of its four types the two parallel to a face remain, and the
  // plane halfway between them treats both bodies alike.
  const Vec3 n = (step.face_normal(pair.b) - step.face_normal(pair.a)).normalized();
  const Vec3 e1 = n.unitOrthogonal(), e2 = n.cross(e1);
  const ContactFace &fa = step.features.faces[pair.a], &fb = step.features.faces[pair.b];
  const Vec3& origin = step.x[step.features.outline(pair.a)[0]];
  const FlatPlane plane{origin, e1, e2};
  ProjectedFace &a = flat_[0], &b = flat_[1];
  a.project(step, pair.a, plane, true);
  b.project(step, pair.b, plane, false);
  const double size = step.broad.size(fa.body, fb.body),
               least_overlap = step.tolerances.least_overlap_area * size * size;
  if (2 * a.most_overlap(b) < least_overlap) return;  // clearly
  const double least_face = step.tolerances.least_facet_area;
  if (!a.has_area(least_face) || !b.has_area(least_face)) return;
  const OverlapPolygon& polygon = polygon_;
  talus::overlap(a.points, b.points, step.tolerances, polygon_);
  if (polygon.corners.empty()) return;
  if (!(polygon.area > least_overlap)) return;

  a.measure_sides();
  b.measure_sides();
  // A strip between a sharp edge of one body and one of the other that has just passed it: two bodies lie flush, or one
  // has sunk by as much as the strip is wide. It would hold a block that nothing holds.
  const SharpEdgesAlong sharp_edges(step, pair.a, fb.body, a, polygon, e1, e2);
  if (sharp_edges.any() && sharp_edges.opposite_to(SharpEdgesAlong(step, pair.b, fa.body, b, polygon, e1, e2),
                                                   step.tolerances.opposite_edges))
    return;

  const double spread_by = spread(step, pair);
  const std::size_t first = corners_.size(), first_covered = found.covered.size();
  double least_gap = std::numeric_limits<double>::infinity();
  a.project_facets(step, pair.a, plane);
  b.project_facets(step, pair.b, plane);
  for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
    // The outline runs straight on there, but for rounding.
    if (!(polygon.weights[i] > step.tolerances.least_sector * polygon.area)) continue;
    Corner c{0, {}, polygon.weights[i] / spread_by, {}, n};
    c.facets = {a.locate(polygon.corners[i], c.at.data()), b.locate(polygon.corners[i], c.at.data() + 3)};
    const auto &of_a = step.features.facets[c.facets[0]].nodes, &of_b = step.features.facets[c.facets[1]].nodes;
    Vec3 apart = Vec3::Zero();
    for (int k = 0; k < 3; ++k)
      apart += c.at[k] * (step.x[of_a[k]] - origin) - c.at[3 + k] * (step.x[of_b[k]] - origin);
    least_gap = std::min(least_gap, n.dot(apart));
    name(step, polygon.corners[i], c, found);
    corners_.push_back(c);
  }
  const auto beside = [&] {
    place_corners(step, first);
    const auto any = [](const Vec3&) { return true; };
    const auto least_deep = [&] { return axis.confirms(step, fa.body, fb.body, least_gap); };
    return step.came_past_sharp_edge(pair.b, places_[0], fa.body, any, least_deep) ||
           step.came_past_sharp_edge(pair.a, places_[1], fb.body, any, least_deep);
  };
  if (least_gap > step.reach(fa.body, fb.body) || least_gap < -step.depth(fa.body, fb.body) ||
      axis.refutes(step, fa.body, fb.body, least_gap) ||
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
      on_a += c.at[k] * step.x[step.features.facets[c.facets[0]].nodes[k]];
      on_b += c.at[3 + k] * step.x[step.features.facets[c.facets[1]].nodes[k]];
    }
    places_[0].push_back(on_a);
    places_[1].push_back(on_b);
  }
}

/// Which features cross at the corner. A vertex that lies amid a facet slides along it, and so does a sharp edge that
/// crosses an edge of the mesh; sharp edges slide along each other. Along the plane halfway they would rise or sink by
/// half the angle between both facets.
void FaceFaceSearch::name(const StepGeometry& step, const Vec2& corner, Corner& c, FoundPoints& found) {
  const ContactFacet &fa = step.features.facets[c.facets[0]], &fb = step.features.facets[c.facets[1]];
  const int at_a = flat_[0].node_at(corner, step.tolerances.at_vertex),
            at_b = flat_[1].node_at(corner, step.tolerances.at_vertex);
  const bool tilted = (step.normal(c.facets[0]) + step.normal(c.facets[1])).norm() > step.tolerances.noticeable_tilt;
  if (at_a >= 0) {
    c.key = vertex_key(at_a, fb.smooth_face);
    if (at_b >= 0)
      found.covered.push_back({vertex_key(at_b, fa.smooth_face), at_b, c.facets[0], -c.normal});
    else
      c.glide = Glide::second_facet;
  } else if (at_b >= 0) {
    c.key = vertex_key(at_b, fa.smooth_face);
    c.glide = Glide::first_facet;
  } else {
    const int ea = flat_[0].nearest_side(corner), eb = flat_[1].nearest_side(corner);
    c.key = crossing_key(step.features, ea, fa.smooth_face, eb, fb.smooth_face);
    const bool sharp_a = step.features.edges[ea].is_sharp, sharp_b = step.features.edges[eb].is_sharp;
    if (sharp_a != sharp_b) {
      c.glide = sharp_a ? Glide::second_facet : Glide::first_facet;
    } else if (sharp_a && tilted) {
      if (const auto across = normal_across(step, ea, eb, c.normal)) {
        c.glide = Glide::edges;
        c.normal = *across;
      }
    }
  }
  if (!tilted) return;
  if (c.glide == Glide::first_facet) c.normal = -step.normal(c.facets[0]);
  if (c.glide == Glide::second_facet) c.normal = step.normal(c.facets[1]);
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
        p.glide = c.glide;
        p.facets = c.facets;
      }
    }
    int of_first = 0;
    for (int side = 0; side < 2; ++side) {
      const int begin = static_cast<int>(found.nodes.size());
      for (std::size_t j = i; j < end; ++j) {
        const Corner& c = corners_[by_key_[j].second];
        const auto& nodes = facets[c.facets[side]].nodes;
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
