#include "contact/contact_points.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/units.hpp"
#include "contact/contact_memory.hpp"

namespace talus {
namespace {

constexpr double least_weight = 1e-6;  // a stencil's share below it is rounding, and would couple nodes for nothing
constexpr double depth_per_penetration = 3;
constexpr double rim_least = 1e-4, rim_most = 1e-2, rim_per_penetration = 3;  // of the size; of the size; –

}  // namespace

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

void FoundPoints::add_vertex(FoundPoint p, const std::array<int, 3>& facet_nodes, const std::array<double, 3>& shares,
                             bool node_is_first, const ContactFeatures& features, std::span<const Vec3> x) {
  p.stencil_begin = static_cast<int>(nodes.size());
  const auto put = [&](int node, double weight) {
    nodes.push_back(node);
    weights.push_back(weight);
  };
  if (node_is_first) put(p.node, 1);
  for (int k = 0; k < 3; ++k) put(facet_nodes[k], node_is_first ? -shares[k] : shares[k]);
  if (!node_is_first) put(p.node, -1);
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

double StepGeometry::rim(int body_a, int body_b) const {
  const double size = broad.scale(body_a, body_b).size;
  return std::clamp(rim_per_penetration * deepest(body_a, body_b), rim_least * size, rim_most * size);
}

bool StepGeometry::within_rim(double distance, int body, int other, const Vec3& beyond) const {
  if (distance < rim_least * broad.scale(body, other).size) return true;
  if (!(distance < widest_rim(body, other))) return false;
  const auto held_by_a_third = [&](int b, const Vec3& direction, int but) {
    return moved[b] ? memory.depth_along(b, direction, but) : 0;
  };
  const double held = std::max(held_by_a_third(other, beyond, body), held_by_a_third(body, -beyond, other));
  return distance < rim_per_penetration * held;
}

double StepGeometry::widest_rim(int body_a, int body_b) const { return rim_most * broad.scale(body_a, body_b).size; }

double StepGeometry::seen_depth(int body_a, int body_b) const {
  return rim_least / 2 * broad.scale(body_a, body_b).size;
}

double StepGeometry::depth(int body_a, int body_b) const {
  const double most =
      std::min(settings.depth * broad.scale(body_a, body_b).size, std::min(widths[body_a], widths[body_b]) / 2);
  return begun(body_a, body_b) ? std::min(reach + depth_per_penetration * deepest(body_a, body_b), most) : most;
}

int StepGeometry::common_joint(int facet_a, int facet_b) const {
  const int joint = features.facets[facet_a].joint;
  return joint == features.facets[facet_b].joint ? joint : -1;
}

Vec3 StepGeometry::fresh_normal(int facet) const {
  const auto& n = features.facets[facet].nodes;
  return (x[n[1]] - x[n[0]]).cross(x[n[2]] - x[n[0]]).stableNormalized();
}

double cone_tolerance(const ContactSettings& settings) { return std::sin(radians(settings.facing_angle)); }

// Two bits for the kind, then 31 for each of two numbers; a crossing of facing facets also tells on which side of its
// edge.
std::uint64_t vertex_key(int node, int patch) {
  return std::uint64_t{1} << 62 | static_cast<std::uint64_t>(node) << 31 | static_cast<std::uint64_t>(patch);
}

std::uint64_t crossing_key(const ContactFeatures& features, int edge_a, int patch_a, int edge_b, int patch_b) {
  const auto side = [&](int edge, int patch) {
    const ContactEdge& e = features.edges[edge];
    const bool second = features.facets[e.facets[0]].patch != patch;
    return static_cast<std::uint64_t>(edge) << 1 | static_cast<std::uint64_t>(second);
  };
  return std::uint64_t{2} << 62 | side(edge_a, patch_a) << 31 | side(edge_b, patch_b);
}

std::uint64_t edge_key(int edge_a, int edge_b) {
  return std::uint64_t{3} << 62 | static_cast<std::uint64_t>(edge_a) << 31 | static_cast<std::uint64_t>(edge_b);
}

std::array<int, 2> edges_of(const FoundPoint& crossing) {
  constexpr std::uint64_t number = 0x7fffffff;
  return {static_cast<int>(crossing.key >> 31 & number), static_cast<int>(crossing.key & number)};
}

std::uint64_t patch_family(int patch_a, int patch_b) { return vertex_key(patch_a, patch_b); }
std::uint64_t crease_family(int crease_a, int crease_b) { return edge_key(crease_a, crease_b); }

}  // namespace talus
