#include "contact/narrow/updated_normal.hpp"

#include <Eigen/Geometry>

namespace talus {
namespace {

/// That of its face.
Vec3 facet_normal(const ContactFeatures& features, int facet, std::span<const Vec3> x) {
  const auto& n = features.facets[features.faces[features.facets[facet].face].facet].nodes;
  return (x[n[1]] - x[n[0]]).cross(x[n[2]] - x[n[0]]).stableNormalized();
}

Vec3 edge_direction(const ContactEdge& e, std::span<const Vec3> x) { return x[e.nodes[1]] - x[e.nodes[0]]; }

/// What the point's features say of its normal, of either sign.
Vec3 direction(const ContactFeatures& features, const FoundPoint& p, std::span<const Vec3> x) {
  if (p.kind == PointKind::edge_edge || (p.node < 0 && p.glide == Glide::edges)) {
    const auto [a, b] = edges_of(p);
    return edge_direction(features.edges[a], x).cross(edge_direction(features.edges[b], x)).stableNormalized();
  }
  const auto of_side = [&](int k) { return facet_normal(features, p.facets[k], x); };
  if (p.node < 0 && p.glide != Glide::halfway) return of_side(p.glide == Glide::first_facet ? 0 : 1);
  if (p.node < 0) return (of_side(1) - of_side(0)).stableNormalized();
  return of_side(features.body_of(p.node) == p.bodies[0] ? 1 : 0);
}

}  // namespace

Vec3 updated_normal(const ContactFeatures& features, const FoundPoint& p, std::span<const Vec3> start,
                    std::span<const Vec3> end) {
  if (p.kind == PointKind::vertex_vertex) return p.normal;
  const Vec3 after = direction(features, p, end);
  if (p.is_of_end) return after.dot(p.normal) < 0 ? Vec3(-after) : after;
  const Vec3 before = direction(features, p, start);
  const double sign = before.dot(p.normal) < 0 ? -1 : 1;
  return (p.normal + sign * (after - before)).stableNormalized();
}

}  // namespace talus
