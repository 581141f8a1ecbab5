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
      normal_at_(normals_.size()),
      core_at_(towards_core_.size()),
      edge_at_(edges_.size()) {
  for (const ContactFace& face : features.faces) body_of_face_.push_back(face.body);
  for (const ContactEdge& edge : features.edges) body_of_edge_.push_back(features.facets[edge.facets[0]].body);
}

void FeatureShapes::measure_normal(int face) {
  const ContactFacet& f = features_.facets[features_.faces[face].facet];
  const Vec3& origin = x_[f.nodes[0]];
  normals_[face] = (x_[f.nodes[1]] - origin).cross(x_[f.nodes[2]] - origin).stableNormalized();
}

void FeatureShapes::measure_core(int node) {
  Mat3 matrix = tolerances_.core_regularization * Mat3::Identity();
  Vec3 right = Vec3::Zero();
  for (const int facet : features_.facets_at(node)) {
    const Vec3& n = normal(features_.facets[facet].face);
    matrix += n * n.transpose();
    right -= n;
  }
  Vec3& inwards = towards_core_[node];
  inwards = matrix.inverse() * right;
  const double depth = inwards.norm();
  if (depth > tolerances_.deepest_core) inwards *= tolerances_.deepest_core / depth;
}

void FeatureShapes::measure_edge(int number) {
  const ContactEdge& e = features_.edges[number];
  Edge& edge = edges_[number];
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
}

}  // namespace talus
