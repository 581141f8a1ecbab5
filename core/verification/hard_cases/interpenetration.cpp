#include "verification/hard_cases/interpenetration.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace talus {

namespace {

double distance_to_segment(const Vec3& point, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double fraction = std::clamp((point - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (point - a - fraction * along).norm();
}

constexpr double beside_edge = 1e-9;  // of a triangle's area: nothing falls between two of them

Box box_of(const BodySet& bodies, int block) {
  const Body& body = bodies.bodies[block];
  Box box;
  for (int n = 0; n < body.node_count; ++n) box.add(bodies.nodes.position[body.first_node + n]);
  return box;
}

}  // namespace

OuterPlanes::OuterPlanes(const std::vector<SurfaceTriangle>& triangles, const std::vector<Vec3>& positions, int first,
                         int count) {
  constexpr std::size_t most = 24;
  constexpr double rounding = 1e-9;  // of the block's size along the normal
  const std::size_t stride = triangles.size() / most + 1;
  for (std::size_t t = 0; t < triangles.size(); t += stride) {
    const auto [a, b, c] = triangles[t].nodes;
    const Vec3 &at = positions[first + a], normal = (positions[first + b] - at).cross(positions[first + c] - at);
    double farthest = 0, nearest = 0;  // from the triangle, so that where the block lies costs no digits
    for (int n = 0; n < count; ++n) {
      const double along = normal.dot(positions[first + n] - at);
      farthest = std::max(farthest, along);
      nearest = std::min(nearest, along);
    }
    planes_.push_back({normal, at, farthest + rounding * (farthest - nearest)});
  }
}

bool OuterPlanes::lie_before_one(const Vec3& a, const Vec3& b) const {
  return std::any_of(planes_.begin(), planes_.end(), [&](const Plane& plane) {
    return plane.normal.dot(a - plane.at) > plane.farthest && plane.normal.dot(b - plane.at) > plane.farthest;
  });
}

double distance_to_triangle(const Vec3& point, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = (b - a).cross(c - a);
  const auto beside = [&](const Vec3& p, const Vec3& q) { return (q - p).cross(point - p).dot(normal) < 0; };
  if (normal.squaredNorm() > 0 && !beside(a, b) && !beside(b, c) && !beside(c, a))
    return std::abs((point - a).dot(normal)) / normal.norm();
  return std::min(
      {distance_to_segment(point, a, b), distance_to_segment(point, b, c), distance_to_segment(point, c, a)});
}

std::optional<double> fraction_to_triangle(const Vec3& from, const Vec3& to, const Vec3& a, const Vec3& b,
                                           const Vec3& c) {
  const Vec3 normal = (b - a).cross(c - a);
  const double before = normal.dot(from - a), behind = normal.dot(to - a);
  if ((before > 0) == (behind > 0)) return std::nullopt;
  const double fraction = before / (before - behind);
  const Vec3 place = from + fraction * (to - from);
  const double least = -beside_edge * normal.squaredNorm();
  const auto within = [&](const Vec3& p, const Vec3& q) { return (q - p).cross(place - p).dot(normal) >= least; };
  return within(a, b) && within(b, c) && within(c, a) ? std::optional(fraction) : std::nullopt;
}

double winding_number(const Vec3& point, const std::vector<SurfaceTriangle>& triangles,
                      const std::vector<Vec3>& positions, int first) {
  double angle = 0;
  for (const SurfaceTriangle& triangle : triangles) {
    const Vec3 a = positions[first + triangle.nodes[0]] - point, b = positions[first + triangle.nodes[1]] - point,
               c = positions[first + triangle.nodes[2]] - point;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    angle += 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return angle / (4 * std::numbers::pi);
}

InterpenetrationCheck::InterpenetrationCheck(const BlockSystem& system) : system_(system) {
  for (const Block& block : system.blocks) surfaces_.push_back(make_surface(block.mesh.nodes, block.surface));
}

std::vector<Vec3> InterpenetrationCheck::points_of(const BodySet& bodies, int block) const {
  const Body& body = bodies.bodies[block];
  const auto node = [&](int n) { return bodies.nodes.position[body.first_node + n]; };
  std::vector<Vec3> points;
  for (int n = 0; n < body.node_count; ++n) points.push_back(node(n));
  for (const auto& [a, b, c, d] : system_.blocks[block].mesh.tetrahedra)
    points.push_back((node(a) + node(b) + node(c) + node(d)) / 4);
  return points;
}

std::vector<Vec3> InterpenetrationCheck::inner_edge_points(const BodySet& bodies, int block, int other, const Box& box,
                                                           const OuterPlanes& planes) const {
  const auto node = [&](int b, int n) -> const Vec3& { return bodies.nodes.position[bodies.bodies[b].first_node + n]; };
  std::vector<Vec3> points;
  std::vector<double> fractions;
  for (const SurfaceEdge& edge : surfaces_[block].edges) {
    const Vec3 &from = node(block, edge.nodes[0]), &to = node(block, edge.nodes[1]);
    Box around;
    around.add(from);
    around.add(to);
    if (!around.within(box, 0) || planes.lie_before_one(from, to)) continue;
    fractions.clear();
    for (const auto& [nodes, joint] : surfaces_[other].triangles) {
      const auto fraction =
          fraction_to_triangle(from, to, node(other, nodes[0]), node(other, nodes[1]), node(other, nodes[2]));
      if (fraction) fractions.push_back(*fraction);
    }
    std::sort(fractions.begin(), fractions.end());
    for (std::size_t i = 1; i < fractions.size(); ++i)
      points.push_back(from + (fractions[i - 1] + fractions[i]) / 2 * (to - from));
  }
  return points;
}

double InterpenetrationCheck::depth_in(const BodySet& bodies, int block, const Box& box, const OuterPlanes& planes,
                                       const std::vector<Vec3>& points, double known) const {
  const auto& triangles = surfaces_[block].triangles;
  const auto& positions = bodies.nodes.position;
  const int first = bodies.bodies[block].first_node;
  double deepest = known;
  for (const Vec3& point : points) {
    // A point that is no farther inside the box than the deepest so far is no deeper in the block.
    if ((point - box.lower).cwiseMin(box.upper - point).minCoeff() <= deepest) continue;
    if (planes.lie_before_one(point, point)) continue;
    double depth = std::numeric_limits<double>::infinity();
    for (const SurfaceTriangle& triangle : triangles) {
      const auto [a, b, c] = triangle.nodes;
      depth = std::min(depth,
                       distance_to_triangle(point, positions[first + a], positions[first + b], positions[first + c]));
      if (depth <= deepest) break;
    }
    if (depth > deepest && winding_number(point, triangles, positions, first) > 0.5) deepest = depth;
  }
  return deepest;
}

Interpenetration InterpenetrationCheck::deepest(const BodySet& bodies, double known) const {
  const int count = static_cast<int>(bodies.bodies.size());
  std::vector<Box> boxes;
  for (int b = 0; b < count; ++b) boxes.push_back(box_of(bodies, b));
  std::vector<std::optional<OuterPlanes>> planes(count);
  const auto planes_of = [&](int b) -> const OuterPlanes& {
    const Body& body = bodies.bodies[b];
    if (!planes[b]) planes[b].emplace(surfaces_[b].triangles, bodies.nodes.position, body.first_node, body.node_count);
    return *planes[b];
  };
  Interpenetration worst{known};
  const auto look = [&](int b, int other, const std::vector<Vec3>& points) {
    const double size = bodies.bodies[b].built_fixed()       ? surfaces_[other].size
                        : bodies.bodies[other].built_fixed() ? surfaces_[b].size
                                                             : std::min(surfaces_[b].size, surfaces_[other].size);
    constexpr double rounding = 1e-12;  // what is as deep as the deepest may seem to be deeper
    const double seen = (1 - rounding) * worst.depth * size;
    const double depth = depth_in(bodies, other, boxes[other], planes_of(other), points, seen) / size;
    if (depth > worst.depth) worst = {depth, b, other};
  };
  const auto may_meet = [&](int b, int other) {
    const bool both_fixed = bodies.bodies[b].built_fixed() && bodies.bodies[other].built_fixed();
    return other != b && !both_fixed && boxes[b].within(boxes[other], 0);
  };
  for (int b = 0; b < count; ++b) {
    const std::vector<Vec3> points = points_of(bodies, b);
    for (int other = 0; other < count; ++other)
      if (may_meet(b, other)) look(b, other, points);
  }
  // A corner that lies inside is told rather than the edges of the other block that go through this one.
  for (int b = 0; b < count; ++b)
    for (int other = 0; other < count; ++other)
      if (may_meet(b, other)) look(b, other, inner_edge_points(bodies, b, other, boxes[other], planes_of(other)));
  return worst;
}

}  // namespace talus
