#include "mesh/surface.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "base/units.hpp"
#include "mesh/mesh_size.hpp"

namespace talus {
namespace {

constexpr double flat_angle = 2.0;  // degrees; below it an edge belongs to the mesh, not to the shape

struct HalfEdge {
  int low, high;  // nodes
  int triangle, opposite;
  bool forward;  // runs from low to high
  bool operator<(const HalfEdge& o) const {
    if (low != o.low) return low < o.low;
    if (high != o.high) return high < o.high;
    return forward && !o.forward;
  }
  bool same_nodes(const HalfEdge& o) const { return low == o.low && high == o.high; }
};

std::vector<HalfEdge> sorted_half_edges(const std::vector<SurfaceTriangle>& triangles, std::size_t node_count) {
  std::vector<HalfEdge> halves;
  halves.reserve(3 * triangles.size());
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t) {
    for (int k = 0; k < 3; ++k) {
      const int from = triangles[t].nodes[(k + 1) % 3], to = triangles[t].nodes[(k + 2) % 3];
      if (from < 0 || static_cast<std::size_t>(from) >= node_count || from == to) {
        throw std::invalid_argument("surface triangle " + std::to_string(t) +
                                    " has a node that does not exist or twice");
      }
      halves.push_back({std::min(from, to), std::max(from, to), t, k, from < to});
    }
  }
  std::sort(halves.begin(), halves.end());
  return halves;
}

/// An edge is two half edges that run against each other; anything else is a hole, a fold or a facet turned over.
void join_edges(const std::vector<HalfEdge>& halves, Surface& surface) {
  surface.triangle_edges.resize(surface.triangles.size());
  for (std::size_t i = 0; i < halves.size(); i += 2) {
    const bool two = i + 1 < halves.size() && halves[i].same_nodes(halves[i + 1]) && halves[i].forward &&
                     !halves[i + 1].forward && (i + 2 == halves.size() || !halves[i].same_nodes(halves[i + 2]));
    if (!two) {
      throw std::invalid_argument("surface is open or its triangles are not oriented alike at the edge of nodes " +
                                  std::to_string(halves[i].low) + " and " + std::to_string(halves[i].high));
    }
    const int edge = static_cast<int>(surface.edges.size());
    surface.edges.push_back({{halves[i].low, halves[i].high}, {halves[i].triangle, halves[i + 1].triangle}});
    for (const HalfEdge& h : {halves[i], halves[i + 1]}) surface.triangle_edges[h.triangle][h.opposite] = edge;
  }
}

void flood_smooth_faces(const std::vector<Vec3>& normals, Surface& surface) {
  const double flat = std::cos(radians(flat_angle));
  surface.smooth_face.assign(surface.triangles.size(), -1);
  std::vector<int> open;
  for (int seed = 0; seed < static_cast<int>(surface.triangles.size()); ++seed) {
    if (surface.smooth_face[seed] >= 0) continue;
    surface.smooth_face[seed] = surface.smooth_face_count;
    open.assign(1, seed);
    while (!open.empty()) {
      const int triangle = open.back();
      open.pop_back();
      for (int e : surface.triangle_edges[triangle]) {
        const auto& sides = surface.edges[e].triangles;
        const int other = sides[0] == triangle ? sides[1] : sides[0];
        if (surface.smooth_face[other] >= 0 || !(normals[triangle].dot(normals[other]) > flat)) continue;
        surface.smooth_face[other] = surface.smooth_face_count;
        open.push_back(other);
      }
    }
    ++surface.smooth_face_count;
  }
}

void find_rings_and_corners(std::span<const Vec3> nodes, Surface& surface) {
  surface.ring.resize(nodes.size());
  std::vector<std::vector<Vec3>> sharp_edges(nodes.size());
  for (const SurfaceEdge& e : surface.edges) {
    const auto [a, b] = e.nodes;
    surface.ring[a].push_back(b);
    surface.ring[b].push_back(a);
    if (surface.smooth_face[e.triangles[0]] == surface.smooth_face[e.triangles[1]]) continue;
    const Vec3 along = (nodes[b] - nodes[a]).normalized();
    sharp_edges[a].push_back(along);
    sharp_edges[b].push_back(-along);
  }
  const double straight = -std::cos(radians(flat_angle));
  surface.corner.resize(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const bool passes = sharp_edges[i].size() == 2 && sharp_edges[i][0].dot(sharp_edges[i][1]) < straight;
    surface.corner[i] = !sharp_edges[i].empty() && !passes;
  }
}

}  // namespace

Surface make_surface(std::span<const Vec3> nodes, std::vector<SurfaceTriangle> triangles) {
  if (triangles.empty()) throw std::invalid_argument("surface has no triangles");
  Surface surface;
  surface.triangles = std::move(triangles);
  join_edges(sorted_half_edges(surface.triangles, nodes.size()), surface);

  std::vector<Vec3> normals;
  normals.reserve(surface.triangles.size());
  double volume = 0;
  const Vec3 origin = nodes[surface.triangles[0].nodes[0]];
  for (const SurfaceTriangle& t : surface.triangles) {
    const Vec3 p = nodes[t.nodes[0]];
    const Vec3 twice = (nodes[t.nodes[1]] - p).cross(nodes[t.nodes[2]] - p);
    volume += twice.dot(p - origin) / 6;
    normals.push_back(twice.stableNormalized());
  }
  if (!(volume > 0)) throw std::invalid_argument("surface is inside out, or it encloses nothing");
  surface.size = mesh_size(nodes, surface.triangles);
  flood_smooth_faces(normals, surface);
  surface.faces = plane_faces(nodes, surface);
  surface.is_convex = no_edge_is_concave(nodes, surface);
  surface.supporting = supporting_faces(nodes, surface);
  find_rings_and_corners(nodes, surface);
  return surface;
}

}  // namespace talus
