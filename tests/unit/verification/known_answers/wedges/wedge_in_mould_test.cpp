#include "verification/known_answers/wedges/wedge_in_mould.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "mesh/surface.hpp"
#include "verification/known_answers/wedges/wedge_test_table.hpp"

namespace {

using namespace talus;

double enclosed_volume(const ClosedSurface& surface) {
  double volume = 0;
  for (const auto& [a, b, c] : surface.triangles)
    volume += surface.nodes[a].dot(surface.nodes[b].cross(surface.nodes[c])) / 6;
  return volume;
}

WedgeShape block_1() { return wedge_between({7.0 / 16, 1, 1}, {7.0 / 16, -1, 1}, 0.16); }

TEST(WedgeInMould, PlanesCutTheWedgeOfTheTests) {
  const WedgeShape wedge = block_1();
  EXPECT_TRUE(wedge.foot.isApprox(Vec3(0.16, 0, -0.07), 1e-12));
  EXPECT_TRUE(wedge.side_1.isApprox(Vec3(0.16, -0.07, 0), 1e-12));
  EXPECT_TRUE(wedge.side_2.isApprox(Vec3(0.16, 0.07, 0), 1e-12));
  EXPECT_TRUE(wedge.planes().normals[0].isApprox(Vec3(7.0 / 16, 1, 1).normalized(), 1e-12));
  EXPECT_TRUE(wedge.planes().normals[1].isApprox(Vec3(7.0 / 16, -1, 1).normalized(), 1e-12));
}

TEST(WedgeInMould, MouldIsAClosedBoxLessTheWedge) {
  const WedgeShape wedge = block_1();
  const ClosedSurface surface = mould(wedge);
  std::vector<SurfaceTriangle> triangles;
  for (const auto& triangle : surface.triangles) triangles.push_back({triangle, -1});
  EXPECT_NO_THROW(make_surface(surface.nodes, triangles));
  const double box = 0.32 * 0.28 * 0.14, notch = 0.16 * 0.14 * 0.07 / 6;
  EXPECT_NEAR(enclosed_volume(surface), box - notch, 1e-12);
}

TEST(WedgeInMould, FacetsOfTheNotchLookIntoTheWedge) {
  const WedgeShape wedge = block_1();
  const ClosedSurface surface = mould(wedge);
  for (int plane = 0; plane < 2; ++plane) {
    const auto& [a, b, c] = surface.triangles[plane];
    const Vec3 normal = (surface.nodes[b] - surface.nodes[a]).cross(surface.nodes[c] - surface.nodes[a]);
    EXPECT_TRUE(normal.normalized().isApprox(wedge.planes().normals[plane], 1e-12));
  }
}

TEST(WedgeInMould, SceneHoldsTheWholeWedgeHoweverFineItsMesh) {
  for (const WedgeTest& test : {wedge_tests().front(), wedge_tests().back()}) {
    const double volume = test.block == 1 ? 0.16 * 0.14 * 0.07 / 6 : 0.10 * 0.20 * 0.10 / 6;
    for (const int refinements : {0, 1, 2}) {
      const CaseScene scene = wedge_in_mould(test.shape(), test.turn(), plaster(), {}, refinements);
      ASSERT_EQ(scene.system.blocks.size(), 2u);
      EXPECT_EQ(scene.system.blocks[0].body, BodyKind::fixed);
      EXPECT_NEAR(scene.system.blocks[1].volume, volume, 1e-12);
      EXPECT_EQ(scene.system.blocks[1].mesh.tetrahedra.size(), std::size_t{1} << (3 * refinements));
    }
  }
}

}  // namespace
