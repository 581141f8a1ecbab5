#include "contact/found_point.hpp"

#include <algorithm>
#include <cmath>

namespace talus {

void FoundPoints::clear() {
  points.clear();
  nodes.clear();
  weights.clear();
  covered.clear();
}

void FoundPoints::close_stencil(FoundPoint& point, const ContactFeatures& features, std::span<const Vec3> x,
                                int nodes_of_first) {
  const int begin = point.stencil_begin, end = static_cast<int>(nodes.size());
  const int middle = begin + nodes_of_first;
  int kept = begin;
  double sum[2] = {0, 0};
  const auto keep = [&](int from, int to, double& total) {
    for (int i = from; i < to; ++i) {
      if (!(std::abs(weights[i]) > least_weight)) continue;
      total += std::abs(weights[i]);
      nodes[kept] = nodes[i];
      weights[kept++] = weights[i];
    }
  };
  keep(begin, middle, sum[0]);
  const int second = kept;
  keep(middle, end, sum[1]);
  nodes.resize(kept);
  weights.resize(kept);

  const Vec3 origin = x[features.facets[point.facets[0]].nodes[0]];
  Vec3 difference = Vec3::Zero();
  point.position = origin;
  for (int i = begin; i < kept; ++i) {
    weights[i] /= sum[i >= second];
    const Vec3 part = weights[i] * (x[nodes[i]] - origin);
    difference += part;
    if (i < second) point.position += part;
  }
  point.gap = point.normal.dot(difference);
  point.stencil_end = kept;
  for (int k = 0; k < 2; ++k) point.bodies[k] = features.facets[point.facets[k]].body;
}

void FoundPoints::add_vertex(FoundPoint p, const std::array<int, 3>& facet_nodes, const std::array<double, 3>& at,
                             bool node_is_first, const ContactFeatures& features, std::span<const Vec3> x) {
  p.stencil_begin = static_cast<int>(nodes.size());
  const auto& [a, b, c] = facet_nodes;
  if (node_is_first) {
    nodes.insert(nodes.end(), {p.node, a, b, c});
    weights.insert(weights.end(), {1, -at[0], -at[1], -at[2]});
  } else {
    nodes.insert(nodes.end(), {a, b, c, p.node});
    weights.insert(weights.end(), {at[0], at[1], at[2], -1});
  }
  close_stencil(p, features, x, node_is_first ? 1 : 3);
  points.push_back(p);
}

void FoundPoints::add_between(FoundPoint p, const std::array<int, 2>& of_first, double s,
                              const std::array<int, 2>& of_second, double t, const ContactFeatures& features,
                              std::span<const Vec3> x) {
  p.stencil_begin = static_cast<int>(nodes.size());
  nodes.insert(nodes.end(), {of_first[0], of_first[1], of_second[0], of_second[1]});
  weights.insert(weights.end(), {1 - s, s, -(1 - t), -t});
  close_stencil(p, features, x, 2);
  points.push_back(p);
}

void FoundPoints::add_of_end(const FoundPoints& others, const FoundPoint& point, std::span<const Vec3> x) {
  FoundPoint p = point;
  p.dropped = false;
  p.is_of_end = true;
  p.stencil_begin = static_cast<int>(nodes.size());
  nodes.insert(nodes.end(), others.nodes.begin() + point.stencil_begin, others.nodes.begin() + point.stencil_end);
  weights.insert(weights.end(), others.weights.begin() + point.stencil_begin,
                 others.weights.begin() + point.stencil_end);
  p.stencil_end = static_cast<int>(nodes.size());
  const Vec3 origin = x[nodes[p.stencil_begin]];
  p.gap = p.normal.dot(difference(p, [&](int node) { return x[node]; }));
  p.position = origin;
  for (int i = p.stencil_begin; i < p.stencil_end; ++i)
    if (weights[i] > 0) p.position += weights[i] * (x[nodes[i]] - origin);
  const auto place =
      std::lower_bound(points.begin(), points.end(), p.key, [](const FoundPoint& q, auto key) { return q.key < key; });
  if (place != points.end() && place->key == p.key)
    *place = p;
  else
    points.insert(place, p);
}

// Two bits for the kind, then 31 for each of two numbers; where edges of two overlapping facets cross the key also
// tells on which side of each edge.
std::uint64_t vertex_key(int node, int smooth_face) {
  return std::uint64_t{1} << 62 | static_cast<std::uint64_t>(node) << 31 | static_cast<std::uint64_t>(smooth_face);
}

std::uint64_t crossing_key(const ContactFeatures& features, int edge_a, int face_a, int edge_b, int face_b) {
  const auto side = [&](int edge, int smooth_face) {
    const ContactEdge& e = features.edges[edge];
    const bool second = features.facets[e.facets[0]].smooth_face != smooth_face;
    return static_cast<std::uint64_t>(edge) << 1 | static_cast<std::uint64_t>(second);
  };
  return std::uint64_t{2} << 62 | side(edge_a, face_a) << 31 | side(edge_b, face_b);
}

std::uint64_t edge_key(int edge_a, int edge_b) {
  return std::uint64_t{3} << 62 | static_cast<std::uint64_t>(edge_a) << 31 | static_cast<std::uint64_t>(edge_b);
}

std::array<int, 2> edges_of(const FoundPoint& crossing) {
  constexpr std::uint64_t number = 0x7fffffff;
  const int sides = crossing.kind == PointKind::face_face ? 1 : 0;  // bits that tell on which side of the edge
  return {static_cast<int>((crossing.key >> 31 & number) >> sides), static_cast<int>((crossing.key & number) >> sides)};
}

std::uint64_t face_family(int face_a, int face_b) { return vertex_key(face_a, face_b); }
std::uint64_t sharp_edge_family(int sharp_edge_a, int sharp_edge_b) { return edge_key(sharp_edge_a, sharp_edge_b); }

}  // namespace talus
