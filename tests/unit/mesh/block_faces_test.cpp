#include "mesh/block_faces.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <tuple>

#include "mesh/structured_mesh.hpp"
#include "support/small_scenes.hpp"

namespace talus {
namespace {

/// A slab on a floor, and a wall beside the slab that covers half of its side.
BlockSystem slab_beside_a_wall() {
  BlockSystem system;
  system.blocks = {test::box_block("floor", Vec3(-5, -5, -1), Vec3(5, 5, 0)),
                   test::box_block("slab", Vec3(0, 0, 0), Vec3(2, 1, 1)),
                   test::box_block("wall", Vec3(2, 0, 0), Vec3(3, 1, 0.5))};
  return system;
}

TEST(BlockFaces, SaysWhereBlocksLieAgainstEachOther) {
  const BlockFaces all = block_faces(slab_beside_a_wall());
  ASSERT_EQ(all.faces.size(), 18U);
  for (const FlatFace& face : all.faces) EXPECT_EQ(face.triangles.size(), 2U);
  ASSERT_EQ(all.shared.size(), 3U);
  double floor = 0, side = 0;
  for (const SharedFace& shared : all.shared)
    (std::abs(all.faces[shared.face].normal.z()) > 0.5 ? floor : side) += shared.area;
  EXPECT_NEAR(floor, 2 + 1, 1e-12);
  EXPECT_NEAR(side, 0.5, 1e-12);
}

/// Meshes of the two sides do not match, and are finer on one.
TEST(BlockFaces, SharedAreasDoNotDependOnTheMeshes) {
  BlockSystem system;
  for (const auto& [min, max, cells, mirrored] :
       {std::tuple(Vec3(0, 0, 0), Vec3(3, 2, 1), 5, false), std::tuple(Vec3(1, -1, 1), Vec3(2.5, 1, 2), 3, true)}) {
    Block block;
    block.mesh = box_mesh(min, max, cells, cells, cells, mirrored);
    block.surface = boundary(block.mesh);
    system.blocks.push_back(block);
  }
  const BlockFaces all = block_faces(system);
  ASSERT_EQ(all.shared.size(), 1U);
  EXPECT_NEAR(all.shared[0].area, 1.5, 1e-12);
}

}  // namespace
}  // namespace talus
