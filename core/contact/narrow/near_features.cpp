#include "contact/narrow/near_features.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace talus {
namespace {

/// Whether all nodes of a face are farther than `distance` from the plane of another, on one side.
bool apart(const StepGeometry& step, int face, int from, double distance) {
  const Vec3 &normal = step.face_normal(from), &origin = step.x[step.features.outline(from)[0]];
  bool above = true, below = true;
  for (const int node : step.features.outline(face)) {
    const double height = normal.dot(step.x[node] - origin);
    above = above && height > distance;
    below = below && height < -distance;
    if (!above && !below) return false;
  }
  return true;
}

}  // namespace

void NearFeatures::clear() {
  faces_.clear();
  facing_.clear();
  vertices_.clear();
  corners_.clear();
  crossing_.clear();
  parallel_.clear();
  ends_.clear();
}

void NearFeatures::add(const StepGeometry& step, const std::array<int, 2>& bodies, std::span<const FacePair> pairs,
                       double distance) {
  const std::size_t first = faces_.size();
  const double most_cosine = -step.face_face_cosine;
  for (const FacePair& pair : pairs) {
    if (apart(step, pair.a, pair.b, distance) || apart(step, pair.b, pair.a, distance)) continue;
    faces_.push_back(pair);
    if (step.face_normal(pair.a).dot(step.face_normal(pair.b)) < most_cosine) facing_.push_back(pair);
    add_features(step, pair, distance);
  }
  if (faces_.size() == first) return;
  ends_.push_back({bodies, step.depth(bodies[0], bodies[1]), vertices_.size(), crossing_.size(), parallel_.size(),
                   corners_.size()});
}

void NearFeatures::add_features(const StepGeometry& step, const FacePair& pair, double distance) {
  const ContactFeatures& features = step.features;
  const std::array<int, 2> faces = {pair.a, pair.b};
  for (int side = 0; side < 2; ++side) {
    const int other = faces[1 - side];
    const Box& box = step.broad.box(other);
    for (const int node : features.owned_nodes(faces[side])) {
      const Vec3& p = step.x[node];
      const Box at{p, p};
      if (!box.within(at, distance)) continue;
      vertices_.push_back({node, other, side == 0});
      if (!features.corner[node]) continue;
      for (const int edge : features.owned_edges(other)) {
        if (features.edges[edge].is_sharp && at.within(step.shapes.edge(edge).box, distance))
          corners_.push_back({node, edge, side == 0});
      }
    }
  }
  for (const int a : features.owned_edges(pair.a)) {
    const Box& box = step.shapes.edge(a).box;
    for (const int b : features.owned_edges(pair.b))
      if (box.within(step.shapes.edge(b).box, distance)) add_edges(step, a, b);
  }
}

void NearFeatures::add_edges(const StepGeometry& step, int edge_a, int edge_b) {
  const ContactEdge &a = step.features.edges[edge_a], &b = step.features.edges[edge_b];
  const FeatureShapes::Edge &shape_a = step.shapes.edge(edge_a), &shape_b = step.shapes.edge(edge_b);
  if (!shape_a.is_convex || !shape_b.is_convex) return;
  const Vec3 u = step.x[a.nodes[1]] - step.x[a.nodes[0]], w = step.x[b.nodes[1]] - step.x[b.nodes[0]];
  if (u.cross(w).squaredNorm() > step.tolerances.parallel_edges * u.squaredNorm() * w.squaredNorm()) {
    if (shape_a.is_clearly_convex && shape_b.is_clearly_convex) crossing_.push_back({edge_a, edge_b});
  } else if (a.is_sharp && b.is_sharp) {
    parallel_.push_back({edge_a, edge_b});
  }
}

}  // namespace talus
