#include "mesh/plane_faces.hpp"

#include <gtest/gtest.h>

#include "mesh/surface.hpp"
#include "unit/contact/blocks.hpp"

namespace talus {
namespace {

using testing::box;
using testing::Shape;

Surface surface_of(const Shape& shape) { return make_surface(shape.nodes, shape.triangles); }

TEST(PlaneFaces, ABoxHasSixOfFourNodes) {
  const Shape shape = box({0, 0, 0}, {3, 2, 1});
  const Surface s = surface_of(shape);
  ASSERT_EQ(s.faces.size(), 6U);
  for (const PlaneFace& face : s.faces) {
    EXPECT_EQ(face.triangles.size(), 2U);
    ASSERT_EQ(face.outline.size(), 4U);
    const Vec3 &a = shape.nodes[face.outline[0]], &b = shape.nodes[face.outline[1]], &c = shape.nodes[face.outline[2]];
    const Vec3 outwards = (a + c) / 2 - Vec3(1.5, 1, 0.5);
    EXPECT_GT((b - a).cross(c - b).dot(outwards), 0) << "clockwise";
  }
  EXPECT_TRUE(s.is_convex);
}

TEST(PlaneFaces, TrianglesAroundANodeInsideStayAlone) {
  const Surface s = surface_of(box({0, 0, 0}, {1, 1, 1}, {2, 2, 1}));
  for (const PlaneFace& face : s.faces) EXPECT_TRUE(face.triangles.size() == 1 || face.outline.size() == 6U);
  EXPECT_EQ(s.faces.size(), 16U + 4U) << "two faces have a node inside, four do not";
}

TEST(PlaneFaces, AJointEndsAFace) {
  Shape shape = box({0, 0, 0}, {1, 1, 1});
  shape.triangles[0].joint = 0;
  EXPECT_EQ(surface_of(shape).faces.size(), 7U);
}

TEST(PlaneFaces, ThoseThatAreNotConvexAreLeftInTriangles) {
  const auto corner = [](int i, int j, int) { return i == 0 || j == 0; };
  const Surface s = surface_of(testing::cells({2, 2, 1}, corner));
  EXPECT_FALSE(s.is_convex);
  int polygons = 0;
  for (const PlaneFace& face : s.faces) polygons += face.triangles.size() > 1;
  EXPECT_EQ(polygons, 6) << "the sides, but not the two ends";
}

TEST(PlaneFaces, WhatIsBentByMoreThanRoundingIsNone) {
  Shape shape = box({0, 0, 0}, {1, 1, 1});
  shape.nodes[7] += Vec3(1e-6, 1e-6, 1e-6);
  EXPECT_GT(surface_of(shape).faces.size(), 6U);
}

}  // namespace
}  // namespace talus
