#include "contact/narrow/updated_normal.hpp"

#include <Eigen/Geometry>

namespace talus {
namespace {

using Positions = std::function<Vec3(int)>;

/// That of its face.
Vec3 facet_normal(const ContactFeatures& features, int facet, const Positions& at) {
  const auto& n = features.facets[features.faces[features.facets[facet].face].facet].nodes;
  const Vec3 origin = at(n[0]);
  return (at(n[1]) - origin).cross(at(n[2]) - origin).stableNormalized();
}

Vec3 edge_direction(const ContactEdge& e, const Positions& at) { return at(e.nodes[1]) - at(e.nodes[0]); }

/// What the point's features say of its normal, of either sign.
Vec3 direction(const ContactFeatures& features, const FoundPoint& p, const Positions& at) {
  if (p.kind == PointKind::edge_edge || (p.node < 0 && p.glide == Glide::edges)) {
    const auto [a, b] = edges_of(p);
    return edge_direction(features.edges[a], at).cross(edge_direction(features.edges[b], at)).stableNormalized();
  }
  const auto of_side = [&](int k) { return facet_normal(features, p.facets[k], at); };
  if (p.node < 0 && p.glide != Glide::halfway) return of_side(p.glide == Glide::first_facet ? 0 : 1);
  if (p.node < 0) return (of_side(1) - of_side(0)).stableNormalized();
  return of_side(features.body_of(p.node) == p.bodies[0] ? 1 : 0);
}

}  // namespace

Vec3 updated_normal(const ContactFeatures& features, const FoundPoint& p, const Positions& start,
                    const Positions& end) {
  if (p.kind == PointKind::vertex_vertex) return p.normal;
  const Vec3 after = direction(features, p, end);
  if (p.is_of_end) return after.dot(p.normal) < 0 ? Vec3(-after) : after;
  const Vec3 before = direction(features, p, start);
  const double sign = before.dot(p.normal) < 0 ? -1 : 1;
  return (p.normal + sign * (after - before)).stableNormalized();
}

}  // namespace talus
