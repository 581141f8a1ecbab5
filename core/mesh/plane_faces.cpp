#include "mesh/plane_faces.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <map>

#include "mesh/surface.hpp"

namespace talus {
namespace {

constexpr double in_plane = 1e-9;  // of the mesh size: rounding of positions

struct Plane {
  Vec3 normal, origin;
  double height(const Vec3& p) const { return normal.dot(p - origin); }
};
Plane plane_of(std::span<const Vec3> nodes, const SurfaceTriangle& triangle) {
  const auto& n = triangle.nodes;
  return {(nodes[n[1]] - nodes[n[0]]).cross(nodes[n[2]] - nodes[n[0]]).stableNormalized(), nodes[n[0]]};
}

class Search {
 public:
  Search(std::span<const Vec3> nodes, const Surface& surface)
      : nodes_(nodes), surface_(surface), is_taken_(surface.triangles.size(), false) {
    for (const SurfaceTriangle& t : surface.triangles) {
      const Vec3& origin = nodes[t.nodes[0]];
      twice_.push_back((nodes[t.nodes[1]] - origin).cross(nodes[t.nodes[2]] - origin));
    }
  }

  /// From the largest triangle on, whose plane is known best.
  std::vector<PlaneFace> run() {
    std::vector<int> order(twice_.size());
    for (std::size_t t = 0; t < order.size(); ++t) order[t] = static_cast<int>(t);
    std::sort(order.begin(), order.end(), [&](int a, int b) {
      const double of_a = twice_[a].squaredNorm(), of_b = twice_[b].squaredNorm();
      return of_a != of_b ? of_a > of_b : a < b;
    });
    for (const int seed : order)
      if (!is_taken_[seed]) add(seed);
    std::sort(faces_.begin(), faces_.end(), [](const PlaneFace& p, const PlaneFace& q) {
      return *std::min_element(p.triangles.begin(), p.triangles.end()) <
             *std::min_element(q.triangles.begin(), q.triangles.end());
    });
    return std::move(faces_);
  }

 private:
  void add(int seed) {
    PlaneFace face{in_plane_of(seed), {}};
    if (face.triangles.size() > 1) face.outline = outline_of(face.triangles);
    if (!face.outline.empty() && is_convex(face.outline, twice_[seed].normalized())) {
      faces_.push_back(std::move(face));
      return;
    }
    for (const int t : face.triangles) {
      const auto& n = surface_.triangles[t].nodes;
      faces_.push_back({{t}, {n[0], n[1], n[2]}});
    }
  }

  std::vector<int> in_plane_of(int seed) {
    const Vec3 normal = twice_[seed].normalized(), &origin = nodes_[surface_.triangles[seed].nodes[0]];
    const auto lies_there = [&](int triangle) {
      const auto& n = surface_.triangles[triangle].nodes;
      return surface_.triangles[triangle].joint == surface_.triangles[seed].joint && twice_[triangle].dot(normal) > 0 &&
             std::all_of(n.begin(), n.end(), [&](int node) {
               return std::abs(normal.dot(nodes_[node] - origin)) < in_plane * surface_.size;
             });
    };
    std::vector<int> triangles{seed};
    is_taken_[seed] = true;
    for (std::size_t i = 0; i < triangles.size(); ++i)
      for (const int e : surface_.triangle_edges[triangles[i]])
        for (const int t : surface_.edges[e].triangles) {
          if (is_taken_[t] || !lies_there(t)) continue;
          is_taken_[t] = true;
          triangles.push_back(t);
        }
    return triangles;
  }

  /// Nothing where a node lies inside, or where the triangles have a hole.
  std::vector<int> outline_of(const std::vector<int>& triangles) const {
    std::map<int, int> next;
    for (const int t : triangles)
      for (int k = 0; k < 3; ++k) {
        const auto& sides = surface_.edges[surface_.triangle_edges[t][k]].triangles;
        const int across = sides[0] == t ? sides[1] : sides[0];
        const auto& n = surface_.triangles[t].nodes;
        if (std::find(triangles.begin(), triangles.end(), across) == triangles.end())
          next[n[(k + 1) % 3]] = n[(k + 2) % 3];
      }
    if (next.size() != triangles.size() + 2) return {};
    std::vector<int> outline;
    for (int node = next.begin()->first; outline.size() < next.size(); node = next[node]) outline.push_back(node);
    return next[outline.back()] == outline.front() ? outline : std::vector<int>{};
  }

  bool is_convex(const std::vector<int>& outline, const Vec3& normal) const {
    const std::size_t count = outline.size();
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3 &at = nodes_[outline[i]], in = at - nodes_[outline[(i + count - 1) % count]],
                 out = nodes_[outline[(i + 1) % count]] - at;
      if (normal.dot(in.cross(out)) < -in_plane * surface_.size * (in.norm() + out.norm())) return false;
    }
    return true;
  }

  std::span<const Vec3> nodes_;
  const Surface& surface_;
  std::vector<bool> is_taken_;  // a triangle
  std::vector<Vec3> twice_;     // a triangle: its normal, as long as twice its area [m²]
  std::vector<PlaneFace> faces_;
};

}  // namespace

std::vector<PlaneFace> plane_faces(std::span<const Vec3> nodes, const Surface& surface) {
  return Search(nodes, surface).run();
}

std::vector<int> supporting_faces(std::span<const Vec3> nodes, const Surface& surface) {
  std::vector<int> supporting;
  for (int face = 0; face < static_cast<int>(surface.faces.size()); ++face) {
    const Plane plane = plane_of(nodes, surface.triangles[surface.faces[face].triangles[0]]);
    const auto lies_below = [&](const Vec3& p) { return plane.height(p) < in_plane * surface.size; };
    if (surface.is_convex || std::all_of(nodes.begin(), nodes.end(), lies_below)) supporting.push_back(face);
  }
  return supporting;
}

bool no_edge_is_concave(std::span<const Vec3> nodes, const Surface& surface) {
  return std::all_of(surface.edges.begin(), surface.edges.end(), [&](const SurfaceEdge& e) {
    const Plane plane = plane_of(nodes, surface.triangles[e.triangles[0]]);
    const auto& beside = surface.triangles[e.triangles[1]].nodes;
    return std::all_of(beside.begin(), beside.end(),
                       [&](int node) { return plane.height(nodes[node]) < in_plane * surface.size; });
  });
}

}  // namespace talus
