#include "mesh/quality.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace talus {
namespace {

const Vec3 origin{0, 0, 0}, ex{1, 0, 0}, ey{0, 1, 0}, ez{0, 0, 1};

TEST(MeshQuality, IsOneForARegularTetrahedronOfAnySize) {
  for (const double s : {1e-3, 1.0, 1e4})
    EXPECT_NEAR(tetrahedron_quality(s * Vec3(1, 1, 1), s * Vec3(1, -1, -1), s * Vec3(-1, 1, -1), s * Vec3(-1, -1, 1)),
                1, 1e-14);
}

TEST(MeshQuality, OfACubesCornerIsKnown) {
  // r = 3V/S = 1 / (3 + √3), R = √3/2
  EXPECT_NEAR(tetrahedron_quality(origin, ex, ey, ez), std::sqrt(3) - 1, 1e-14);
}

TEST(MeshQuality, DihedralAnglesAreThoseOfTheCubesCorner) {
  // Three right angles, and three at the slanted face: tan = √2.
  const DihedralRange corner = tetrahedron_dihedrals(origin, ex, ey, ez);
  EXPECT_NEAR(corner.smallest, std::atan(std::sqrt(2)) * 180 / std::acos(-1), 1e-12);
  EXPECT_NEAR(corner.largest, 90, 1e-12);
  const MeshQuality quality = mesh_quality({{origin, ex, ey, ez}, {{0, 1, 2, 3}}});
  EXPECT_DOUBLE_EQ(quality.smallest_dihedral, corner.smallest);
  EXPECT_DOUBLE_EQ(quality.largest_dihedral, corner.largest);
}

TEST(MeshQuality, FallsToZeroAsATetrahedronFlattens) {
  EXPECT_LT(tetrahedron_quality(origin, ex, ey, Vec3(0.3, 0.3, 1e-4)), 1e-3);
  EXPECT_EQ(tetrahedron_quality(origin, ex, ey, Vec3(0.3, 0.3, 0)), 0);
  EXPECT_EQ(tetrahedron_quality(origin, origin, origin, origin), 0);
}

TEST(MeshQuality, OfAMeshIsItsWorstAndItsMean) {
  const TetMesh mesh{{origin, ex, ey, ez, Vec3(0.3, 0.3, -1e-4)}, {{0, 1, 2, 3}, {0, 2, 1, 4}}};
  const MeshQuality quality = mesh_quality(mesh);
  const double flat = tetrahedron_quality(origin, ey, ex, mesh.nodes[4]);
  EXPECT_DOUBLE_EQ(quality.worst, flat);
  EXPECT_NEAR(quality.mean, (std::sqrt(3) - 1 + flat) / 2, 1e-14);
}

}  // namespace
}  // namespace talus
