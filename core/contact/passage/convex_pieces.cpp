#include "contact/passage/convex_pieces.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <map>

namespace talus {
namespace {

const ConvexShape tetrahedron{
    {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}},
    {{{0, 1}, {0, 1}}, {{1, 2}, {0, 2}}, {{0, 2}, {0, 3}}, {{0, 3}, {1, 3}}, {{1, 3}, {1, 2}}, {{2, 3}, {2, 3}}}};

Vec3 area_vector(const Vec3& a, const Vec3& b, const Vec3& c) { return (b - a).cross(c - a) / 2; }

/// The planes of a convex surface, each by its outward normal, and of each triangle the number of its own.
struct Planes {
  std::vector<Vec3> normals;
  std::vector<int> of_triangles;
};

Planes planes_of(const Surface& surface, std::span<const Vec3> x) {
  constexpr double same = 1 - 1e-12;  // cosine of two normals
  const auto normal_of = [&](int t) {
    const auto [a, b, c] = surface.triangles[t].nodes;
    return area_vector(x[a], x[b], x[c]).normalized();
  };
  Planes planes;
  const auto nearest = [&](const Vec3& normal) {
    return std::max_element(planes.normals.begin(), planes.normals.end(),
                            [&](const Vec3& p, const Vec3& q) { return p.dot(normal) < q.dot(normal); });
  };
  for (const int face : surface.supporting) {
    const Vec3 normal = normal_of(surface.faces[face].triangles[0]);
    if (planes.normals.empty() || nearest(normal)->dot(normal) < same) planes.normals.push_back(normal);
  }
  for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t)
    planes.of_triangles.push_back(static_cast<int>(nearest(normal_of(t)) - planes.normals.begin()));
  return planes;
}

/// Nodes where three planes meet: the corners of the polyhedron, without those that only its mesh has. Of each plane
/// the numbers of its corners among them.
std::vector<std::vector<int>> find_corners(const Surface& surface, const Planes& planes, std::vector<int>& corners,
                                           std::vector<int>& corner_of) {
  std::vector<std::vector<int>> planes_at(surface.ring.size()), corners_of(planes.normals.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (const int node : surface.triangles[t].nodes) {
      auto& known = planes_at[node];
      const int plane = planes.of_triangles[t];
      if (std::find(known.begin(), known.end(), plane) == known.end()) known.push_back(plane);
    }
  corner_of.assign(planes_at.size(), -1);
  for (std::size_t n = 0; n < planes_at.size(); ++n) {
    if (planes_at[n].size() < 3) continue;
    corner_of[n] = static_cast<int>(corners.size());
    corners.push_back(static_cast<int>(n));
    for (const int plane : planes_at[n]) corners_of[plane].push_back(corner_of[n]);
  }
  return corners_of;
}

/// Three corners of a plane, of the widest triangle that the first has with others.
std::array<int, 3> widest_triangle(const Vec3& normal, std::span<const int> of_plane, std::span<const int> corners,
                                   std::span<const Vec3> x) {
  std::array<int, 3> widest{};
  double most = 0;
  const auto at = [&](int corner) { return x[corners[corner]]; };
  for (const int second : of_plane)
    for (const int third : of_plane) {
      const double area = normal.dot(area_vector(at(of_plane[0]), at(second), at(third)));
      if (area <= most) continue;
      most = area;
      widest = {of_plane[0], second, third};
    }
  return widest;
}

/// The polyhedron of a convex surface; `corners`: its nodes.
ConvexShape make_shape(const Surface& surface, std::span<const Vec3> x, std::vector<int>& corners) {
  const Planes planes = planes_of(surface, x);
  std::vector<int> corner_of;
  const std::vector<std::vector<int>> corners_of = find_corners(surface, planes, corners, corner_of);
  ConvexShape shape;
  for (std::size_t plane = 0; plane < corners_of.size(); ++plane)
    shape.faces.push_back(widest_triangle(planes.normals[plane], corners_of[plane], corners, x));
  std::map<std::pair<int, int>, std::vector<int>> ends;  // of two planes: the corners where their edge ends
  for (const SurfaceEdge& edge : surface.edges) {
    const auto between = std::minmax(planes.of_triangles[edge.triangles[0]], planes.of_triangles[edge.triangles[1]]);
    if (between.first == between.second) continue;
    for (const int node : edge.nodes)
      if (corner_of[node] >= 0) ends[between].push_back(corner_of[node]);
  }
  for (const auto& [between, at] : ends)
    if (at.size() == 2) shape.edges.push_back({{at[0], at[1]}, {between.first, between.second}});
  return shape;
}

double thickness_of(const Surface& surface, std::span<const Vec3> x) {
  double area = 0, volume = 0;
  for (const SurfaceTriangle& t : surface.triangles) {
    const Vec3 across = area_vector(x[t.nodes[0]], x[t.nodes[1]], x[t.nodes[2]]);
    area += across.norm();
    volume += across.dot(x[t.nodes[0]] - x[0]) / 3;
  }
  return 2 * volume / area;
}

}  // namespace

ConvexPieces::ConvexPieces(const BlockSystem& system, const BodySet& bodies, std::span<const Surface> surfaces) {
  for (std::size_t b = 0; b < surfaces.size(); ++b) {
    const Block& block = system.blocks[b];
    const Body& body = bodies.bodies[b];
    whole_.emplace_back();
    if (surfaces[b].is_convex && (body.built_fixed() || body.single_body())) {
      std::vector<int> corners;
      whole_.back() = std::make_unique<ConvexShape>(make_shape(surfaces[b], block.mesh.nodes, corners));
      for (const int n : corners) nodes_.push_back(body.first_node + n);
      nodes_begin_.push_back(static_cast<int>(nodes_.size()));
    } else {
      for (const auto& corners : block.mesh.tetrahedra) {
        for (const int n : corners) nodes_.push_back(body.first_node + n);
        nodes_begin_.push_back(static_cast<int>(nodes_.size()));
      }
    }
    begin_.push_back(static_cast<int>(nodes_begin_.size()) - 1);
    thickness_.push_back(thickness_of(surfaces[b], block.mesh.nodes));
    sizes_.push_back(body.built_fixed() ? std::numeric_limits<double>::infinity() : surfaces[b].size);
  }
}

ConvexPiece ConvexPieces::piece(int body, int number) const {
  const int i = begin_[body] + number;
  const std::span<const int> nodes{nodes_.data() + nodes_begin_[i], nodes_.data() + nodes_begin_[i + 1]};
  return {whole_[body] ? whole_[body].get() : &tetrahedron, nodes};
}

}  // namespace talus
