#include "contact/narrow/near_features.hpp"

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

/// Whether the boxes about two segments are farther apart than `distance`: most are.
bool apart(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1, double distance) {
  for (int k = 0; k < 3; ++k) {
    const double between =
        std::max(std::min(a0[k], a1[k]) - std::max(b0[k], b1[k]), std::min(b0[k], b1[k]) - std::max(a0[k], a1[k]));
    if (between > distance) return true;
  }
  return false;
}

}  // namespace

void NearFeatures::clear() {
  faces_.clear();
  vertices_.clear();
  corners_.clear();
  edges_.clear();
  ends_.clear();
}

void NearFeatures::add(const StepGeometry& step, const std::array<int, 2>& bodies, std::span<const FacePair> pairs,
                       double distance) {
  const std::size_t first = faces_.size();
  for (const FacePair& pair : pairs) {
    if (apart(step, pair.a, pair.b, distance) || apart(step, pair.b, pair.a, distance)) continue;
    faces_.push_back(pair);
    add_features(step, pair, distance);
  }
  if (faces_.size() > first) ends_.push_back({bodies, edges_.size(), corners_.size()});
}

void NearFeatures::add_features(const StepGeometry& step, const FacePair& pair, double distance) {
  const ContactFeatures& features = step.features;
  const std::array<int, 2> faces = {pair.a, pair.b};
  for (int side = 0; side < 2; ++side) {
    const int other = faces[1 - side];
    const Box& box = step.broad.box(other);
    for (const int node : features.owned_nodes(faces[side])) {
      const Vec3& p = step.x[node];
      if (!box.within({p, p}, distance)) continue;
      vertices_.push_back({node, other, side == 0});
      if (!features.corner[node]) continue;
      for (const int edge : features.owned_edges(other)) {
        const ContactEdge& e = features.edges[edge];
        if (e.is_sharp && !apart(p, p, step.x[e.nodes[0]], step.x[e.nodes[1]], distance))
          corners_.push_back({node, edge, side == 0});
      }
    }
  }
  const auto may_touch = [&](int edge) {
    const FeatureShapes::Edge& shape = step.shapes.edge(edge);
    return shape.is_clearly_convex || (shape.is_convex && features.edges[edge].is_sharp);
  };
  of_b_.clear();
  for (const int edge : features.owned_edges(pair.b))
    if (may_touch(edge)) of_b_.push_back(edge);
  if (of_b_.empty()) return;
  for (const int a : features.owned_edges(pair.a)) {
    if (!may_touch(a)) continue;
    const Vec3 &a0 = step.x[features.edges[a].nodes[0]], &a1 = step.x[features.edges[a].nodes[1]];
    for (const int b : of_b_) {
      const auto& nodes = features.edges[b].nodes;
      if (!apart(a0, a1, step.x[nodes[0]], step.x[nodes[1]], distance)) edges_.push_back({a, b});
    }
  }
}

}  // namespace talus
