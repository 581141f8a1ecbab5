#include "mesh/surface.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

namespace talus {
namespace {

struct Box {
  std::vector<Vec3> nodes;
  std::vector<SurfaceTriangle> triangles;
};

/// Unit cube, faces of n × n cells, two triangles each.
Box unit_cube(int n) {
  Box box;
  const auto node = [&](const Vec3& p) {
    for (std::size_t i = 0; i < box.nodes.size(); ++i) {
      if ((box.nodes[i] - p).norm() < 1e-9) return static_cast<int>(i);
    }
    box.nodes.push_back(p);
    return static_cast<int>(box.nodes.size()) - 1;
  };
  for (int axis = 0; axis < 3; ++axis) {
    for (int side = 0; side < 2; ++side) {
      Vec3 u = Vec3::Unit((axis + 1) % 3) / n, v = Vec3::Unit((axis + 2) % 3) / n;
      if (!side) std::swap(u, v);
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
          const Vec3 p = side * Vec3::Unit(axis) + i * u + j * v;
          const int a = node(p), b = node(p + u), c = node(p + u + v), d = node(p + v);
          box.triangles.push_back({{a, b, c}, -1});
          box.triangles.push_back({{a, c, d}, -1});
        }
      }
    }
  }
  return box;
}

TEST(Surface, CubeHasSixPatchesEightCornersAndEulersEdges) {
  const Box box = unit_cube(3);
  const Surface s = make_surface(box.nodes, box.triangles);
  EXPECT_EQ(s.smooth_face_count, 6);
  EXPECT_EQ(std::count(s.corner.begin(), s.corner.end(), true), 8);
  EXPECT_EQ(s.triangles.size(), 108u);
  EXPECT_EQ(s.edges.size(), 162u);
  EXPECT_EQ(box.nodes.size() + s.triangles.size() - s.edges.size(), 2u);
  EXPECT_NEAR(s.size, 1.0 / 3, 1e-12);
}

TEST(Surface, PatchesAreTheFaces) {
  const Box box = unit_cube(2);
  const Surface s = make_surface(box.nodes, box.triangles);
  std::set<std::pair<int, int>> pairs;  // a face is 8 triangles in a row
  for (std::size_t t = 0; t < s.triangles.size(); ++t) pairs.emplace(t / 8, s.smooth_face[t]);
  EXPECT_EQ(pairs.size(), 6u);
}

TEST(Surface, EdgesAreOppositeToTheirNodesAndKnowTheirTriangles) {
  const Box box = unit_cube(2);
  const Surface s = make_surface(box.nodes, box.triangles);
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const SurfaceEdge& e = s.edges[s.triangle_edges[t][k]];
      std::set<int> all(e.nodes.begin(), e.nodes.end());
      all.insert(s.triangles[t].nodes[k]);
      EXPECT_EQ(all, std::set<int>(s.triangles[t].nodes.begin(), s.triangles[t].nodes.end()));
      EXPECT_EQ(1, std::count(e.triangles.begin(), e.triangles.end(), static_cast<int>(t)));
    }
  }
}

TEST(Surface, RingsAreMutualAndComplete) {
  const Box box = unit_cube(2);
  const Surface s = make_surface(box.nodes, box.triangles);
  std::size_t sum = 0;
  for (std::size_t i = 0; i < s.ring.size(); ++i) {
    sum += s.ring[i].size();
    for (int j : s.ring[i]) EXPECT_EQ(1, std::count(s.ring[j].begin(), s.ring[j].end(), static_cast<int>(i)));
  }
  EXPECT_EQ(sum, 2 * s.edges.size());
}

TEST(Surface, GentleEdgesAreCrossedSharpOnesAreNot) {
  for (const auto& [degrees, smooth_faces] : {std::pair(1.0, 6), std::pair(3.0, 7)}) {
    Box box = unit_cube(2);
    for (Vec3& p : box.nodes) {  // a fold in the top along its middle; its sides stay flat
      if (p.z() > 0.99 && std::abs(p.y() - 0.5) < 1e-9) p.z() += 0.5 * std::tan(degrees / 2 * M_PI / 180);
    }
    EXPECT_EQ(make_surface(box.nodes, box.triangles).smooth_face_count, smooth_faces) << degrees;
  }
}

TEST(Surface, OpenTurnedOrInsideOutThrows) {
  Box open = unit_cube(1);
  open.triangles.pop_back();
  EXPECT_THROW(make_surface(open.nodes, open.triangles), std::invalid_argument);

  Box turned = unit_cube(1);
  std::swap(turned.triangles[3].nodes[0], turned.triangles[3].nodes[1]);
  EXPECT_THROW(make_surface(turned.nodes, turned.triangles), std::invalid_argument);

  Box inside_out = unit_cube(1);
  for (SurfaceTriangle& t : inside_out.triangles) std::swap(t.nodes[0], t.nodes[1]);
  EXPECT_THROW(make_surface(inside_out.nodes, inside_out.triangles), std::invalid_argument);

  Box twice = unit_cube(1);
  const std::vector<SurfaceTriangle> copy = twice.triangles;
  twice.triangles.insert(twice.triangles.end(), copy.begin(), copy.end());
  EXPECT_THROW(make_surface(twice.nodes, twice.triangles), std::invalid_argument);

  Box missing = unit_cube(1);
  missing.triangles[0].nodes[0] = 99;
  EXPECT_THROW(make_surface(missing.nodes, missing.triangles), std::invalid_argument);
  EXPECT_THROW(make_surface(missing.nodes, {}), std::invalid_argument);
}

TEST(Surface, NeedleTriangleMakesNoNaN) {
  // A tetrahedron with a fifth node on one of its edges: one facet has no area.
  const std::vector<Vec3> nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.5, 0, 0}};
  const std::vector<SurfaceTriangle> triangles = {{{0, 2, 1}, -1}, {{0, 4, 3}, -1}, {{4, 1, 3}, -1},
                                                  {{1, 2, 3}, -1}, {{0, 3, 2}, -1}, {{0, 1, 4}, -1}};
  const Surface s = make_surface(nodes, triangles);
  EXPECT_TRUE(std::isfinite(s.size));
  for (int p : s.smooth_face) EXPECT_GE(p, 0);
}

}  // namespace
}  // namespace talus
