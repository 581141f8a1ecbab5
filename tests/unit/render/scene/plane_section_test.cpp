#include "render/scene/plane_section.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "mesh/structured_mesh.hpp"

namespace talus {
namespace {

/// A closed surface of boxes; those that are hollow look inwards.
struct Boxes {
  std::vector<Vec3> points;
  std::vector<std::array<int, 3>> triangles;

  void add(const Vec3& min, const Vec3& max, bool hollow = false) {
    const TetMesh mesh = box_mesh(min, max, 3, 2, 2);
    const int first = static_cast<int>(points.size());
    points.insert(points.end(), mesh.nodes.begin(), mesh.nodes.end());
    for (const SurfaceTriangle& t : boundary(mesh)) {
      std::array<int, 3> triangle{first + t.nodes[0], first + t.nodes[1], first + t.nodes[2]};
      if (hollow) std::swap(triangle[1], triangle[2]);
      triangles.push_back(triangle);
    }
  }
  RockSurface rock() const { return {points, triangles}; }
};

double area(const std::vector<FlatTriangle>& triangles) {
  double sum = 0;
  for (const FlatTriangle& t : triangles) sum += (t[1] - t[0]).cross(t[2] - t[0]).norm() / 2;
  return sum;
}

double length(const std::vector<Edge>& edges) {
  double sum = 0;
  for (const Edge& edge : edges) sum += (edge[1] - edge[0]).norm();
  return sum;
}

Boxes cube() {
  Boxes boxes;
  boxes.add(Vec3::Zero(), Vec3::Ones());
  return boxes;
}

TEST(PlaneSection, OfACubeIsASquareARectangleOrAHexagon) {
  const Boxes boxes = cube();
  EXPECT_NEAR(area(PlaneSection(boxes.rock(), {0, 0, 0.3}, Vec3::UnitZ()).triangles()), 1, 1e-9);
  EXPECT_NEAR(area(PlaneSection(boxes.rock(), {0.5, 0.5, 0.5}, Vec3(1, 0, 1).normalized()).triangles()), std::sqrt(2.0),
              1e-9);
  EXPECT_NEAR(area(PlaneSection(boxes.rock(), {0.5, 0.5, 0.5}, Vec3(1, 1, 1).normalized()).triangles()),
              0.75 * std::sqrt(3.0), 1e-9);
}

TEST(PlaneSection, LiesInThePlane) {
  const Vec3 point(0.4, 0.5, 0.6), normal = Vec3(1, 2, 3).normalized();
  const auto triangles = PlaneSection(cube().rock(), point, normal).triangles();
  ASSERT_FALSE(triangles.empty());
  for (const FlatTriangle& triangle : triangles)
    for (const Vec3& corner : triangle) EXPECT_NEAR(normal.dot(corner - point), 0, 1e-9);
}

TEST(PlaneSection, BesideTheRockIsNothing) {
  EXPECT_TRUE(PlaneSection(cube().rock(), {0, 0, 1.1}, Vec3::UnitZ()).triangles().empty());
  EXPECT_TRUE(PlaneSection({}, {0, 0, 0}, Vec3::UnitZ()).triangles().empty());
}

TEST(PlaneSection, AlongAFaceIsTheFaceOrNothing) {
  for (const double z : {0.0, 1.0}) {
    const double found = area(PlaneSection(cube().rock(), {0, 0, z}, Vec3::UnitZ()).triangles());
    EXPECT_TRUE(std::abs(found) < 1e-9 || std::abs(found - 1) < 1e-9) << found;
  }
}

TEST(PlaneSection, LeavesCavitiesOutAndTakesAllPieces) {
  Boxes boxes;
  boxes.add(Vec3::Zero(), Vec3(4, 4, 4));
  boxes.add(Vec3(1, 1, 1), Vec3(3, 2, 3), true);
  boxes.add(Vec3(6, 0, 0), Vec3(7, 1, 4));
  EXPECT_NEAR(area(PlaneSection(boxes.rock(), {0, 0, 2}, Vec3::UnitZ()).triangles()), 16 - 2 + 1, 1e-9);
}

TEST(PlaneSection, IsClippedByTheSidesOfAPolygon) {
  PlaneSection square(cube().rock(), {0, 0, 0.3}, Vec3::UnitZ());
  const std::vector<Vec3> corner{{0.5, 0.5, 0.3}, {2, 0.5, 0.3}, {2, 2, 0.3}, {0.5, 2, 0.3}};
  for (const HalfSpace& side : sides_of(corner, Vec3::UnitZ())) square.clip(side);
  EXPECT_NEAR(area(square.triangles()), 0.25, 1e-9);
  EXPECT_NEAR(length(square.outline()), 2, 1e-9);
  square.clip({{0.4, 0, 0}, {-1, 0, 0}});
  EXPECT_TRUE(square.triangles().empty()) << "nothing is left";
}

TEST(PlaneSection, HasAnOutlineAroundItAndItsHoles) {
  EXPECT_NEAR(length(PlaneSection(cube().rock(), {0, 0, 0.3}, Vec3::UnitZ()).outline()), 4, 1e-9);
  Boxes boxes;
  boxes.add(Vec3::Zero(), Vec3(4, 4, 4));
  boxes.add(Vec3(1, 1, 1), Vec3(3, 2, 3), true);
  PlaneSection section(boxes.rock(), {0, 0, 2}, Vec3::UnitZ());
  EXPECT_NEAR(length(section.outline()), 16 + 6, 1e-9);
  section.clip({{2, 0, 0}, {1, 0, 0}}, false);  // through the hole
  EXPECT_NEAR(area(section.triangles()), 8 - 1, 1e-9);
  EXPECT_NEAR(length(section.outline()), 8 + 3, 1e-9) << "a border that is none is left out";
}

TEST(TrianglesOf, AHookedPolygonCoverItsArea) {
  const std::vector<Vec3> hook{{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}};
  EXPECT_NEAR(area(triangles_of(hook)), 5, 1e-9);
}

}  // namespace
}  // namespace talus
