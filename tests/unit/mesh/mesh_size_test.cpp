#include "mesh/mesh_size.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/block.hpp"

namespace talus {
namespace {

/// A right-angled corner of legs `leg`: faces of area leg²/2 but the last, √3/2·leg².
Block corner(double leg, BodyKind body) {
  Block block;
  block.body = body;
  block.mesh.nodes = {{0, 0, 0}, {leg, 0, 0}, {0, leg, 0}, {0, 0, leg}};
  const std::array<int, 3> faces[] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  for (const auto& nodes : faces) {
    SurfaceTriangle triangle{};
    triangle.nodes = nodes;
    block.surface.push_back(triangle);
  }
  return block;
}

TEST(MeshSize, IsTheLegOfARightAngledTriangleOfTheMeanArea) {
  const Block block = corner(2, BodyKind::rigid);
  EXPECT_DOUBLE_EQ(mesh_size(block.mesh.nodes, block.surface), 2 * std::sqrt((3 + std::sqrt(3.0)) / 4));
}

TEST(MeshSize, OfAModelIsTheSmallestOfWhatIsNotFixed) {
  BlockSystem system;
  system.blocks = {corner(0.1, BodyKind::fixed), corner(3, BodyKind::rigid), corner(2, BodyKind::affine)};
  EXPECT_DOUBLE_EQ(smallest_mesh_size(system), mesh_size(system.blocks[2].mesh.nodes, system.blocks[2].surface));
}

TEST(MeshSize, IsThatOfANeedleWhereItIsThinnerAndVeryManyTimesAsLong) {
  EXPECT_TRUE(is_needle(6000, 4 * 6000 * 0.1, 1));
  EXPECT_FALSE(is_needle(6000, 4 * 6000 * 0.3, 1)) << "as wide as the size";
  EXPECT_FALSE(is_needle(4000, 4 * 4000 * 0.1, 1)) << "not that long";
}

}  // namespace
}  // namespace talus
