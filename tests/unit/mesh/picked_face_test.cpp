#include "mesh/picked_face.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace talus {
namespace {

/// A box 4 × 2 × 1 m whose top is divided into four triangles round its middle.
Block slab() {
  Block block;
  block.mesh.nodes = {{0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {0, 2, 0}, {0, 0, 1},
                      {4, 0, 1}, {4, 2, 1}, {0, 2, 1}, {2, 1, 1}};
  block.surface = {{{4, 5, 8}}, {{5, 6, 8}}, {{6, 7, 8}}, {{7, 4, 8}}, {{0, 2, 1}}, {{0, 3, 2}}, {{0, 1, 5}},
                   {{0, 5, 4}}, {{1, 2, 6}}, {{1, 6, 5}}, {{2, 3, 7}}, {{2, 7, 6}}, {{3, 0, 4}}, {{3, 4, 7}}};
  return block;
}

bool among(const std::vector<Vec3>& points, const Vec3& wanted) {
  return std::ranges::any_of(points, [&](const Vec3& point) { return (point - wanted).norm() < 1e-12; });
}

TEST(PickedFace, HasTheAreaCentroidAndCornersOfAllItsTriangles) {
  const PickedFace top = face_at(slab(), {0.5, 0.5, 1}, Vec3::UnitZ());
  EXPECT_NEAR(top.area, 8, 1e-12);
  EXPECT_NEAR((top.centroid - Vec3(2, 1, 1)).norm(), 0, 1e-12);
  EXPECT_THAT(top.corners, testing::SizeIs(4));
  for (const Vec3& corner : {Vec3(0, 0, 1), Vec3(4, 0, 1), Vec3(4, 2, 1), Vec3(0, 2, 1)})
    EXPECT_TRUE(among(top.corners, corner)) << corner.transpose();
}

TEST(PickedFace, ANodeWithinAStraightSideIsNoCorner) {
  Block block = slab();
  block.mesh.nodes.push_back({2, 0, 1});
  block.surface[0] = {{4, 9, 8}};
  block.surface.push_back({{9, 5, 8}});
  EXPECT_THAT(face_at(block, {0.5, 0.5, 1}, Vec3::UnitZ()).corners, testing::SizeIs(4));
}

TEST(PickedFace, HasAnOutlineInOrderRoundItsHole) {
  // A square of 4 m about one of 2 m that is missing: eight triangles.
  Block ring;
  ring.mesh.nodes = {{1, 1, 0}, {3, 1, 0}, {3, 3, 0}, {1, 3, 0}, {0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
  for (int side = 0; side < 4; ++side) {
    const int next = (side + 1) % 4;
    ring.surface.push_back({{4 + side, 4 + next, next}});
    ring.surface.push_back({{4 + side, next, side}});
  }
  const PickedFace face = face_at(ring, {0.5, 2, 0}, Vec3::UnitZ());
  EXPECT_NEAR(face.area, 12, 1e-12);
  EXPECT_THAT(face.corners, testing::SizeIs(8));
  ASSERT_THAT(face.outline, testing::SizeIs(4));
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR((face.outline[i] - face.outline[(i + 1) % 4]).norm(), 4, 1e-12) << "side after side";
}

TEST(PickedFace, IsEmptyWhereTheBlockHasNoSuchFace) {
  EXPECT_EQ(face_at(slab(), {0.5, 0.5, 0.5}, Vec3::UnitZ()).area, 0);
  EXPECT_EQ(face_at(slab(), {0.5, 0.5, 1}, -Vec3::UnitZ()).area, 0);
}

}  // namespace
}  // namespace talus
