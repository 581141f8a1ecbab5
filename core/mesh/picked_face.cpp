#include "mesh/picked_face.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace talus {

namespace {

constexpr double same_direction = 1e-3;  // rad
constexpr double same_height = 1e-6;     // of the block's size
constexpr double straight = 0.9998;      // cosine of 1°: below it the outline bends

using Edge = std::pair<int, int>;

/// The sides of the face's triangles that no other of them has, each the way round that its triangle has it.
std::set<Edge> outline_of(const Block& block, const std::vector<int>& triangles) {
  std::set<Edge> sides;
  for (const int t : triangles) {
    const auto& nodes = block.surface[t].nodes;
    for (std::size_t i = 0; i < 3; ++i) {
      const int from = nodes[i], to = nodes[(i + 1) % 3];
      if (sides.erase({to, from}) == 0) sides.insert({from, to});
    }
  }
  return sides;
}

/// The nodes where an outline bends.
std::set<int> bends_of(const Block& block, const std::set<Edge>& outline) {
  std::map<int, Vec3> arrival;
  const auto& nodes = block.mesh.nodes;
  for (const auto& [from, to] : outline) arrival[to] = (nodes[to] - nodes[from]).normalized();
  std::set<int> bends;
  for (const auto& [from, to] : outline)
    if (arrival.at(from).dot((nodes[to] - nodes[from]).normalized()) < straight) bends.insert(from);
  return bends;
}

/// The corners of the outline that is round all others, in order: sides of holes run the other way.
std::vector<Vec3> outermost(const Block& block, std::set<Edge> outline, const std::set<int>& bends,
                            const Vec3& normal) {
  const auto& nodes = block.mesh.nodes;
  std::vector<Vec3> largest;
  double most = 0;
  while (!outline.empty()) {
    const Vec3 begin = nodes[outline.begin()->first];
    std::vector<Vec3> corners;
    double area = 0;
    for (auto side = outline.begin(); side != outline.end();) {
      const auto [from, to] = *side;
      outline.erase(side);
      if (bends.contains(from)) corners.push_back(nodes[from]);
      area += (nodes[from] - begin).cross(nodes[to] - begin).dot(normal) / 2;
      side = outline.lower_bound({to, 0});
      if (side != outline.end() && side->first != to) side = outline.end();
    }
    if (area <= most) continue;
    most = area;
    largest = std::move(corners);
  }
  return largest;
}

}  // namespace

PickedFace face_at(const Block& block, const Vec3& point, const Vec3& normal) {
  Eigen::AlignedBox3d box;
  for (const Vec3& node : block.mesh.nodes) box.extend(node);
  const double tolerance = same_height * box.diagonal().norm();
  PickedFace face{.normal = normal, .corners = {}, .outline = {}};
  std::vector<int> triangles;
  for (std::size_t t = 0; t < block.surface.size(); ++t) {
    const auto& [a, b, c] = block.surface[t].nodes;
    const Vec3 &p = block.mesh.nodes[a], &q = block.mesh.nodes[b], &r = block.mesh.nodes[c];
    const Vec3 twice = (q - p).cross(r - p);
    const double area = twice.norm() / 2;
    if (!(area > 0) || (twice / (2 * area) - normal).norm() > same_direction) continue;
    if (std::abs(normal.dot(p - point)) > tolerance) continue;
    face.area += area;
    face.centroid += area * (p + q + r) / 3;
    triangles.push_back(static_cast<int>(t));
  }
  if (triangles.empty()) return face;
  face.centroid /= face.area;
  const std::set<Edge> outline = outline_of(block, triangles);
  const std::set<int> bends = bends_of(block, outline);
  for (const int node : bends) face.corners.push_back(block.mesh.nodes[node]);
  face.outline = outermost(block, outline, bends, normal);
  return face;
}

}  // namespace talus
