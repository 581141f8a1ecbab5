#include "verification/random/rough_bed.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "mesh/structured_mesh.hpp"
#include "mesh/surface.hpp"

namespace talus {
namespace {

RoughBed drawn_bed(double roughness, double dip) {
  SceneNumbers numbers(3);
  return RoughBed(numbers, 6, 0.5, roughness, dip);
}

TEST(RoughBed, IsAClosedBlockOnAFlatBase) {
  const TetMesh mesh = drawn_bed(0.2, 20).mesh(1);
  for (const auto& t : mesh.tetrahedra) EXPECT_GT(volume({mesh.nodes, {t}}), 0);
  EXPECT_NO_THROW(make_surface(mesh.nodes, boundary(mesh)));
}

/// The triangles that look upwards are the surface that depths are told from.
TEST(RoughBed, DepthIsTheDistanceFromTheTriangleOfItsMesh) {
  const RoughBed bed = drawn_bed(0.2, 20);
  const TetMesh mesh = bed.mesh(1);
  int seen = 0;
  for (const SurfaceTriangle& triangle : boundary(mesh)) {
    const auto at = [&](int k) { return mesh.nodes[triangle.nodes[k]]; };
    const Vec3 normal = (at(1) - at(0)).cross(at(2) - at(0)).normalized();
    if (normal.z() < 0.1) continue;
    const Vec3 inside = 0.5 * at(0) + 0.3 * at(1) + 0.2 * at(2);
    EXPECT_NEAR(bed.depth(inside), 0, 1e-14);
    EXPECT_NEAR(bed.depth(inside - 0.1 / normal.z() * Vec3::UnitZ()), 0.1, 1e-14);
    EXPECT_NEAR(bed.depth(inside + 0.1 / normal.z() * Vec3::UnitZ()), -0.1, 1e-14);
    ++seen;
  }
  EXPECT_EQ(seen, 2 * 6 * 6);
}

TEST(RoughBed, WhatLiesBesideItIsNotDeep) {
  const RoughBed bed = drawn_bed(0.2, 0);
  EXPECT_LT(bed.depth({1.6, 0, -100}), -1e300);
  EXPECT_NEAR(bed.depth({1.4, 0, -100}), 0.1, 1e-12) << "so far is the side";
}

TEST(RoughBed, DipsAndIsHighestUphill) {
  const RoughBed bed = drawn_bed(0, 45);
  EXPECT_NEAR(bed.depth({1, 0.2, -1}), 0, 1e-12);
  EXPECT_NEAR(bed.depth({0, 0.2, -1}), std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(bed.highest_within(0.3), 0.5, 1e-12) << "corners to 0.8 m from the middle";
}

}  // namespace
}  // namespace talus
