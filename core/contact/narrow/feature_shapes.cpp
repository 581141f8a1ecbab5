#include "contact/narrow/feature_shapes.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace talus {

FeatureShapes::FeatureShapes(const ContactFeatures& features, const Odometers& odometers,
                             const ContactTolerances& tolerances)
    : features_(features),
      odometers_(odometers),
      tolerances_(tolerances),
      normals_(features.faces.size()),
      towards_core_(features.node_count()),
      edges_(features.edges.size()),
      has_normal_(normals_.size()),
      has_core_(towards_core_.size()),
      has_edge_(edges_.size()) {
  const auto list_begins = [&](int count, const auto& body_of, std::vector<int>& begins) {
    for (int i = 0; i < count; ++i)
      while (static_cast<int>(begins.size()) <= body_of(i)) begins.push_back(i);
    begins.resize(features.face_begin.size(), count);
  };
  const auto body_of_edge = [&](int edge) { return features.facets[features.edges[edge].facets[0]].body; };
  list_begins(
      features.node_count(), [&](int node) { return features.body_of(node); }, node_begin_);
  list_begins(static_cast<int>(features.edges.size()), body_of_edge, edge_begin_);
}

void FeatureShapes::look(std::span<const Vec3> x) {
  x_ = x;
  const auto forget = [](std::vector<MeasuredOnce>& all, int begin, int end) {
    MeasuredOnce::forget(std::span(all).subspan(begin, end - begin));
  };
  for (const int body : odometers_.moved()) {
    forget(has_normal_, features_.face_begin[body], features_.face_begin[body + 1]);
    forget(has_core_, node_begin_[body], node_begin_[body + 1]);
    forget(has_edge_, edge_begin_[body], edge_begin_[body + 1]);
  }
}

const Vec3& FeatureShapes::measure_normal(int face) {
  has_normal_[face].bring_about([&] { normals_[face] = normal_of(face); });
  return normals_[face];
}

const Vec3& FeatureShapes::measure_core(int node) {
  has_core_[node].bring_about([&] { towards_core_[node] = core_of(node); });
  return towards_core_[node];
}

const FeatureShapes::Edge& FeatureShapes::measure_edge(int number) {
  has_edge_[number].bring_about([&] { edges_[number] = edge_of(number); });
  return edges_[number];
}

Vec3 FeatureShapes::normal_of(int face) const {
  const ContactFacet& f = features_.facets[features_.faces[face].facet];
  const Vec3& origin = x_[f.nodes[0]];
  return (x_[f.nodes[1]] - origin).cross(x_[f.nodes[2]] - origin).stableNormalized();
}

Vec3 FeatureShapes::core_of(int node) {
  Mat3 matrix = tolerances_.core_regularization * Mat3::Identity();
  Vec3 right = Vec3::Zero();
  for (const int facet : features_.facets_at(node)) {
    const Vec3& n = normal(features_.facets[facet].face);
    matrix += n * n.transpose();
    right -= n;
  }
  Vec3 inwards = matrix.inverse() * right;
  const double depth = inwards.norm();
  if (depth > tolerances_.deepest_core) inwards *= tolerances_.deepest_core / depth;
  return inwards;
}

FeatureShapes::Edge FeatureShapes::edge_of(int number) {
  const ContactEdge& e = features_.edges[number];
  Edge edge;
  for (const int node : e.nodes) edge.box.add(x_[node]);
  const Vec3 &origin = x_[e.nodes[0]], u = x_[e.nodes[1]] - origin, r = x_[e.opposite[1]] - origin;
  const double below = normal(features_.facets[e.facets[0]].face).dot(r), along_u = r.dot(u), length = u.squaredNorm();
  const double least = tolerances_.convex_edge_angle;
  edge.is_convex = below < 0;
  edge.is_clearly_convex =
      below < 0 && below * below * length > least * least * (r.squaredNorm() * length - along_u * along_u);
  edge.along = u.stableNormalized();
  for (int k = 0; k < 2; ++k) {
    const Vec3 into = x_[e.opposite[k]] - origin;
    edge.into[k] = (into - edge.along * edge.along.dot(into)).stableNormalized();
  }
  return edge;
}

}  // namespace talus
