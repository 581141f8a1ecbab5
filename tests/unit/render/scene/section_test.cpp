#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "render/scene/section_actor.hpp"

namespace talus {
namespace {

/// The unit tetrahedron beside another one, 2 m to the east.
BlockSystem two_tetrahedra() {
  Block block;
  block.mesh = {{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()}, {{0, 1, 2, 3}}};
  block.surface = {{{0, 2, 1}}, {{0, 1, 3}}, {{1, 2, 3}}, {{0, 3, 2}}};
  Block other = block;
  for (Vec3& node : other.mesh.nodes) node.x() += 2;
  return {.blocks = {block, other}, .joint_names = {}};
}

std::vector<Vec3> places_of(const BlockSystem& system) {
  std::vector<Vec3> places;
  for (const Block& block : system.blocks)
    places.insert(places.end(), block.mesh.nodes.begin(), block.mesh.nodes.end());
  return places;
}

double area_of(const BlockSection& section) {
  double area = 0;
  for (const auto& [corners, block, tetrahedron] : section.triangles)
    area += (corners[1].at - corners[0].at).cross(corners[2].at - corners[0].at).norm() / 2;
  return area;
}

double length_of(const BlockSection& section) {
  double length = 0;
  for (const Edge& edge : section.outlines) length += (edge[1] - edge[0]).norm();
  return length;
}

/// At a quarter of its height a tetrahedron has the 9/16 of its base, and three quarters of its sides.
TEST(BlockSection, HasTheAreaAndTheOutlineOfEachBlock) {
  const BlockSystem system = two_tetrahedra();
  const SectionPlane plane{{0, 0, 0.25}, Vec3::UnitZ()};
  const BlockSection section = section_of(system, places_of(system), {true, true}, plane);
  EXPECT_NEAR(area_of(section), 2 * 9.0 / 32, 1e-12);
  EXPECT_NEAR(length_of(section), 2 * 0.75 * (2 + std::sqrt(2.0)), 1e-12);
  EXPECT_NEAR(area_of(section_of(system, places_of(system), {false, true}, plane)), 9.0 / 32, 1e-12);
}

TEST(BlockSection, ThroughTwoNodesOnEitherSideIsAQuadrangle) {
  const BlockSystem system = two_tetrahedra();
  const SectionPlane plane{{0.25, 0, 0.25}, Vec3(1, 0, 1).normalized()};  // (0, ½) between nodes 0, 2 and 1, 3
  const BlockSection section = section_of(system, places_of(system), {true, false}, plane);
  EXPECT_EQ(section.triangles.size(), 2U);
  // A rectangle of √½ m to the side of ½ m.
  EXPECT_NEAR(area_of(section), std::sqrt(0.5) * 0.5, 1e-12);
}

TEST(BlockSection, CornersKnowBetweenWhichNodesTheyLie) {
  const BlockSystem system = two_tetrahedra();
  const auto places = places_of(system);
  const BlockSection section = section_of(system, places, {true, true}, {{0, 0.3, 0}, Vec3::UnitY()});
  EXPECT_FALSE(section.triangles.empty());
  for (const auto& triangle : section.triangles) {
    EXPECT_EQ(triangle.tetrahedron, triangle.block);
    for (const auto& corner : triangle.corners) {
      const Vec3 &one = places[static_cast<std::size_t>(corner.one)],
                 &other = places[static_cast<std::size_t>(corner.other)];
      EXPECT_LT((one + corner.share * (other - one) - corner.at).norm(), 1e-12);
      EXPECT_EQ(corner.one / 4, triangle.block);
      EXPECT_NEAR(corner.at.y(), 0.3, 1e-12);
    }
  }
}

TEST(BlockSection, OfASolidWithoutTetrahedraIsThatOfItsSurface) {
  BlockSystem system = two_tetrahedra();
  for (Block& block : system.blocks) block.mesh.tetrahedra.clear();
  const BlockSection section = section_of(system, places_of(system), {true, true}, {{0, 0, 0.25}, Vec3::UnitZ()});
  EXPECT_NEAR(area_of(section), 2 * 9.0 / 32, 1e-9);
}

}  // namespace
}  // namespace talus
