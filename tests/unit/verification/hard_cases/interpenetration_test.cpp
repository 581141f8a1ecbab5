#include "verification/hard_cases/interpenetration.hpp"

#include <gtest/gtest.h>

#include "verification/known_answers/support/scene.hpp"

namespace talus {
namespace {

Interpenetration deepest(const CaseScene& scene) {
  return InterpenetrationCheck(scene.system).deepest(BodySet(scene.project, scene.system));
}

/// A cube of 1 m, mesh size 1 m, whose base lies at `height` over a slab of 4 m × 4 m × 1 m.
CaseScene cube_on_slab(double height, const Vec3& offset = Vec3::Zero()) {
  CaseScene scene = rock_scene(30);
  scene.add_fixed_box("slab", offset + Vec3(-2, -2, -1), offset + Vec3(2, 2, 0));
  scene.add_box("cube", offset + Vec3(-0.5, -0.5, height), offset + Vec3(0.5, 0.5, height + 1));
  return scene;
}

TEST(Interpenetration, OfBlocksThatTouchOrAreApartIsNone) {
  EXPECT_EQ(deepest(cube_on_slab(0)).depth, 0);
  EXPECT_EQ(deepest(cube_on_slab(0.1)).depth, 0);
  EXPECT_EQ(deepest(cube_on_slab(0.1)).block, -1);
}

TEST(Interpenetration, IsTheDistanceToTheNearestFaceOverTheMeshSize) {
  const Interpenetration found = deepest(cube_on_slab(-0.02));
  EXPECT_NEAR(found.depth, 0.02, 1e-12);
  EXPECT_EQ(found.block, 1);
  EXPECT_EQ(found.into, 0);
  EXPECT_NEAR(deepest(cube_on_slab(-0.02, Vec3(1e6, 1e6, 1e6))).depth, 0.02, 1e-9);
}

TEST(Interpenetration, OfAFixedBlockIsSeenToo) {
  CaseScene scene = rock_scene(30);
  scene.add_box("plate", Vec3(-2, -2, 0), Vec3(2, 2, 1));
  scene.add_fixed_box("post", Vec3(-0.1, -0.1, -3), Vec3(0.1, 0.1, 0.05));
  const Interpenetration found = deepest(scene);
  EXPECT_EQ(found.block, 1);
  // Triangles of the plate: 4 of 8 m², 8 of 2 m²; its mesh size is √(2 · 4 m²).
  EXPECT_NEAR(found.depth, 0.05 / std::sqrt(8.0), 1e-12);
}

TEST(Interpenetration, ANotchIsOutside) {
  // An L in the plane of x and z: a cube of 2 m without its upper right quarter, in which another cube stands free.
  CaseScene scene = rock_scene(30);
  const std::vector<Vec3> nodes = {{0, 0, 0}, {2, 0, 0}, {2, 0, 1}, {1, 0, 1}, {1, 0, 2}, {0, 0, 2},
                                   {0, 1, 0}, {2, 1, 0}, {2, 1, 1}, {1, 1, 1}, {1, 1, 2}, {0, 1, 2}};
  std::vector<std::array<int, 3>> triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}};
  for (int i = 0; i < 4; ++i) triangles.push_back({triangles[i][0] + 6, triangles[i][2] + 6, triangles[i][1] + 6});
  for (int i = 0; i < 6; ++i) {
    const int j = (i + 1) % 6;
    triangles.push_back({i, i + 6, j});
    triangles.push_back({j, i + 6, j + 6});
  }
  scene.add_ground("L", nodes, triangles);
  scene.add_box("cube", Vec3(1.1, 0.1, 1.1), Vec3(1.8, 0.8, 1.8));
  EXPECT_EQ(deepest(scene).depth, 0);
  scene.add_box("other", Vec3(0.3, 0.2, 1.2), Vec3(0.7, 0.8, 1.6));
  EXPECT_GT(deepest(scene).depth, 0.1);
}

TEST(Interpenetration, OfBarsThatCrossWithoutACornerInsideIsSeen) {
  for (const double depth : {0.02, 0.3}) {
    CaseScene scene = rock_scene(30);
    scene.add_box("below", Vec3(-3, -0.5, -1), Vec3(3, 0.5, 0));
    scene.add_box("above", Vec3(-0.5, -3, -depth), Vec3(0.5, 3, 1 - depth));
    const double size = std::sqrt(2.0 * 26 / 12);  // 12 triangles of 26 m²
    EXPECT_NEAR(deepest(scene).depth, depth / size, 1e-12);
  }
}

TEST(Interpenetration, ASegmentGoesThroughATriangleOrPassesBy) {
  const Vec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0), up(0, 0, 1);
  const auto through = [&](const Vec3& place) { return fraction_to_triangle(place - up, place + 3 * up, a, b, c); };
  EXPECT_DOUBLE_EQ(through({0.2, 0.2, 0}).value(), 0.25);
  EXPECT_TRUE(through({0.5, 0.5, 0})) << "its edge belongs to it";
  EXPECT_FALSE(through({0.6, 0.6, 0}));
  EXPECT_FALSE(through({0.2, 0.2, 1.5})) << "it ends above";
  EXPECT_FALSE(fraction_to_triangle(a, b, a, b, c)) << "it lies in its plane";
}

TEST(Interpenetration, TheWindingNumberTellsInsideFromOutside) {
  const TetMesh box = box_mesh(Vec3::Zero(), Vec3::Ones(), 2, 2, 2);
  const auto surface = boundary(box);
  EXPECT_NEAR(winding_number(Vec3(0.3, 0.9, 0.6), surface, box.nodes, 0), 1, 1e-12);
  EXPECT_NEAR(winding_number(Vec3(1.3, 0.9, 0.6), surface, box.nodes, 0), 0, 1e-12);
  EXPECT_NEAR(winding_number(Vec3(0.5, 0.5, 1e-9), surface, box.nodes, 0), 1, 1e-6);
  EXPECT_NEAR(winding_number(Vec3(0.5, 0.5, -1e-9), surface, box.nodes, 0), 0, 1e-6);
}

TEST(Interpenetration, TheDistanceFromATriangleIsToItsFaceEdgeOrCorner) {
  const Vec3 a(0, 0, 0), b(4, 0, 0), c(0, 4, 0);
  EXPECT_DOUBLE_EQ(distance_to_triangle(Vec3(1, 1, -3), a, b, c), 3);
  EXPECT_DOUBLE_EQ(distance_to_triangle(Vec3(2, -3, 4), a, b, c), 5);
  EXPECT_DOUBLE_EQ(distance_to_triangle(Vec3(-3, -4, 12), a, b, c), 13);
  EXPECT_DOUBLE_EQ(distance_to_triangle(Vec3(4, 4, 0), a, b, c), std::sqrt(8));
}

}  // namespace
}  // namespace talus
