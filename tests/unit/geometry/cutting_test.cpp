#include <cmath>
#include <numbers>

#include "orientation/drawn_planes.hpp"
#include "rock.hpp"

namespace talus {
namespace {

using namespace rock;

TEST(Cutting, UncutBoxKeepsItsNameAndVolume) {
  Project p = project();
  p.solids = {box("slab", {0, 0, 0}, {4, 5, 6}, 2)};
  const BlockSystem system = build(p);
  ASSERT_EQ(system.blocks.size(), 1u);
  EXPECT_EQ(system.blocks[0].name, "slab");
  EXPECT_EQ(joint_areas(system.blocks[0]).count(0), 0u);
  EXPECT_NEAR(joint_areas(system.blocks[0])[-1], 2 * (20 + 24 + 30), 1e-9);
  expect_sound(system, 120);
}

TEST(Cutting, DipAndDipDirectionTurnThePlane) {
  // Through the middle of the cube's west edge at mid-height, dipping east by atan ½: leaves the lower edge at a
  // quarter of the height, so the upper piece holds 5/8 or the lower 3/8 of the volume: 10·10·(5 + 0)/2 = 250 below.
  Project p = project();
  p.solids = {box("cube", {0, 0, 0}, {10, 10, 10}, 5)};
  const double dip = std::atan(0.5) * 180 / std::numbers::pi;
  p.cuts = {cut("J2", dip, 90, {0, 0, 5})};
  BlockSystem system = build(p);
  ASSERT_EQ(system.blocks.size(), 2u);
  expect_sound(system, 1000);
  const auto lower_volume = [](const BlockSystem& of) {
    return of.blocks[of.blocks[0].volume < of.blocks[1].volume ? 0 : 1].volume;
  };
  EXPECT_NEAR(lower_volume(system), 250, 1e-7);
  // Dipping south by the same from mid-height of the north face: the piece below is a wedge at the north side.
  p.cuts = {cut("J2", dip, 180, {0, 10, 5})};
  system = build(p);
  ASSERT_EQ(system.blocks.size(), 2u);
  EXPECT_NEAR(lower_volume(system), 250, 1e-7);
  for (const Block& b : system.blocks) {
    double most_north = 0, highest_at_south = 0;
    for (const Vec3& node : b.mesh.nodes) {
      most_north = std::max(most_north, node.y());
      if (node.y() < 1e-9) highest_at_south = std::max(highest_at_south, node.z());
    }
    EXPECT_DOUBLE_EQ(most_north, 10);
    EXPECT_NEAR(highest_at_south, b.volume < 500 ? 0 : 10, 1e-12);
  }
}

TEST(Cutting, BothSidesOfACutKnowTheJoint) {
  Project p = project();
  p.solids = {box("cube", {0, 0, 0}, {10, 10, 10}, 4)};
  p.cuts = {cut("J2", 0, 0, {3, 3, 4}), cut("J3", 90, 90, {6, 0, 0})};
  const BlockSystem system = build(p);
  ASSERT_EQ(system.blocks.size(), 4u);
  for (const Block& b : system.blocks) {
    auto areas = joint_areas(b);
    double low_x = 1e9, high_x = -1e9, low_z = 1e9, high_z = -1e9;
    for (const Vec3& n : b.mesh.nodes) {
      low_x = std::min(low_x, n.x()), high_x = std::max(high_x, n.x());
      low_z = std::min(low_z, n.z()), high_z = std::max(high_z, n.z());
    }
    EXPECT_NEAR(areas[1], 10 * (high_x - low_x), 1e-9);
    EXPECT_NEAR(areas[2], 10 * (high_z - low_z), 1e-9);
    EXPECT_EQ(areas.count(0), 0u);
  }
  expect_sound(system, 1000);
}

TEST(Cutting, BlocksAreNumberedByTheirCentroids) {
  Project p = project();
  p.solids = {box("cube", {0, 0, 0}, {8, 8, 8}, 8)};
  p.cuts = {cut("J1", 90, 90, {2, 0, 0}), cut("J2", 0, 0, {0, 0, 3})};
  p.blocks = {{"keystone", {1, 4, 5}, BodyKind::fixed, {}, {}}};
  const BlockSystem system = build(p);
  std::vector<std::string> names;
  for (const Block& b : system.blocks) names.push_back(b.name);
  EXPECT_EQ(names, (std::vector<std::string>{"cube.1", "keystone", "cube.3", "cube.4"}));
  EXPECT_NEAR(block(system, "cube.1").volume, 2 * 8 * 3, 1e-9);
  EXPECT_NEAR(block(system, "keystone").volume, 2 * 8 * 5, 1e-9);
  EXPECT_EQ(block(system, "keystone").body, BodyKind::fixed);
  EXPECT_NEAR(block(system, "cube.3").volume, 6 * 8 * 3, 1e-9);
  EXPECT_EQ(block(system, "cube.4").body, BodyKind::tetrahedra);
}

TEST(Cutting, SpacingAndCountRepeatAPlaneUpwards) {
  Project p = project();
  p.solids = {box("column", {0, 0, 0}, {1, 1, 10}, 1)};
  Cut bedding = cut("J1", 0, 0, {0, 0, 1});
  bedding.spacing = 2;
  bedding.count = 4;  // z = 1, 3, 5, 7
  p.cuts = {bedding};
  const BlockSystem system = build(p);
  ASSERT_EQ(system.blocks.size(), 5u);
  const std::vector<double> volumes{1, 2, 2, 2, 3};
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(system.blocks[i].volume, volumes[i], 1e-9);
  expect_sound(system, 10);
}

TEST(Cutting, ASetWithALawOfSpacingCutsWhereItsPlanesAreDrawn) {
  Project p = project();
  p.solids = {box("column", {0, 0, 0}, {1, 1, 10}, 1)};
  Cut bedding = cut("J1", 0, 0, {0, 0, 1});
  bedding.spacing = 2;
  bedding.count = 4;
  bedding.spacing_law = SpacingLaw::exponential;
  bedding.seed = 3;
  std::vector<double> heights{0};
  for (const Cut& plane : single_planes(bedding))
    if (plane.through.z() < 10) heights.push_back(plane.through.z());
  ASSERT_GT(heights.size(), 2u);
  heights.push_back(10);
  p.cuts = {bedding};
  const BlockSystem system = build(p);
  ASSERT_EQ(system.blocks.size(), heights.size() - 1);
  for (std::size_t i = 0; i + 1 < heights.size(); ++i)
    EXPECT_NEAR(system.blocks[i].volume, heights[i + 1] - heights[i], 1e-9);
}

TEST(Cutting, PlanesThatScatterFillTheSolidAndSomeMayMissIt) {
  Project p = project();
  p.solids = {box("cube", {0, 0, 0}, {4, 4, 4}, 4)};
  Cut steep = cut("J1", 70, 90, {0.5, 2, 2});
  steep.spacing = 1.1;
  steep.count = 12;
  steep.fisher_kappa = 150;
  p.cuts = {steep};
  const BlockSystem system = build(p);
  EXPECT_GT(system.blocks.size(), 3u);
  EXPECT_LT(system.blocks.size(), 13u);
  expect_sound(system, 64);
}

TEST(Cutting, ACutMayBeLimitedToSolids) {
  Project p = project();
  p.solids = {box("a", {0, 0, 0}, {2, 2, 2}, 2), box("b", {3, 0, 0}, {5, 2, 2}, 2)};
  p.cuts = {cut("J1", 0, 0, {0, 0, 1})};
  EXPECT_EQ(build(p).blocks.size(), 4u);
  p.cuts[0].solids = {"b"};
  const BlockSystem system = build(p);
  ASSERT_EQ(system.blocks.size(), 3u);
  EXPECT_EQ(system.blocks[0].name, "a");
  EXPECT_EQ(system.blocks[1].name, "b.1");
}

TEST(Cutting, SolidsThatTouchGetTheJointOfAPlaneBetweenThem) {
  Project p = project();
  p.solids = {box("base", {0, 0, 0}, {10, 10, 2}, 4), box("top", {2, 2, 2}, {5, 5, 4}, 2)};
  p.cuts = {cut("J3", 0, 0, {0, 0, 2})};
  const BlockSystem system = build(p);
  ASSERT_EQ(system.blocks.size(), 2u);
  EXPECT_NEAR(joint_areas(block(system, "base"))[2], 100, 1e-9);
  EXPECT_NEAR(joint_areas(block(system, "top"))[2], 9, 1e-9);
}

TEST(Cutting, NonConvexSlopeKeepsItsVolume) {
  Project p = project();
  p.solids = {solid("slope", bench_slope(60), 20)};
  p.cuts = {cut("J1", 35, 80, {60, 30, 40}), cut("J2", 75, 200, {40, 25, 40}), cut("J3", 60, 300, {30, 30, 70})};
  const BlockSystem system = build(p);
  EXPECT_GT(system.blocks.size(), 4u);
  expect_sound(system, bench_slope_area * 60);
}

TEST(Cutting, ABenchsPlaneAlsoDividesTheRockBehindIt) {
  // The lower bench, z = 30 for x > 75, goes on into the slope: the plane lies on a facet and divides as well.
  Project p = project();
  p.solids = {solid("slope", bench_slope(60), 25)};
  p.cuts = {cut("J2", 0, 0, {0, 0, 30})};
  const BlockSystem system = build(p);
  ASSERT_EQ(system.blocks.size(), 2u);
  const Block& lower = system.blocks[system.blocks[0].volume < 190000 ? 0 : 1];
  EXPECT_NEAR(lower.volume, 100 * 30 * 60, 1e-4);
  EXPECT_NEAR(joint_areas(lower)[1], 100 * 60, 1e-6);
  expect_sound(system, bench_slope_area * 60);
}

TEST(Cutting, PlanesThatMeetInOnePointAndInEdges) {
  // The six diagonal planes of a cube, each through two of its edges, make 24 equal blocks.
  Project p = project();
  p.solids = {box("cube", {0, 0, 0}, {10, 10, 10}, 10)};
  p.cuts = {cut("J1", 45, 90, {0, 0, 10}),   cut("J1", 45, 270, {10, 0, 10}), cut("J2", 45, 0, {0, 0, 10}),
            cut("J2", 45, 180, {0, 10, 10}), cut("J3", 90, 45, {0, 10, 0}),   cut("J3", 90, 135, {0, 0, 0})};
  const BlockSystem system = build(p);
  ASSERT_EQ(system.blocks.size(), 24u);
  for (const Block& b : system.blocks) EXPECT_NEAR(b.volume, 1000.0 / 24, 1e-9);
  expect_sound(system, 1000);
}

TEST(Cutting, PlanesThatNearlyCoincideAreMadeOne) {
  Project p = project();
  p.solids = {box("cube", {0, 0, 0}, {10, 10, 10}, 5)};
  p.cuts = {cut("J1", 30, 90, {5, 5, 5}), cut("J1", 30.05, 90, {5, 5, 5}), cut("J1", 30, 90, {5, 5, 5.00005})};
  BlockSystem system = build(p);
  EXPECT_EQ(system.blocks.size(), 2u);
  expect_sound(system, 1000);
  // A thin layer is not a near coincidence.
  p.cuts = {cut("J1", 30, 90, {5, 5, 5}), cut("J1", 30, 90, {5, 5, 5.2})};
  system = build(p);
  EXPECT_EQ(system.blocks.size(), 3u);
  expect_sound(system, 1000);
}

TEST(Cutting, APlaneNearlyOnAFacetGivesItTheJointAndCutsNothing) {
  Project p = project();
  p.solids = {box("cube", {0, 0, 0}, {10, 10, 10}, 5)};
  p.cuts = {cut("J2", 0.03, 90, {5, 5, 10})};
  const BlockSystem system = build(p);
  ASSERT_EQ(system.blocks.size(), 1u);
  EXPECT_NEAR(joint_areas(system.blocks[0])[1], 100, 1e-9);
  expect_sound(system, 1000);
}

TEST(Cutting, CoordinatesRoundedToMillimetresArePutRight) {
  PolyhedronShape shape;
  shape.vertices = {{-65, -686.517, 260.352}, {65, -686.517, 264.701}, {65, -354.934, 137.902},
                    {-65, -354.934, 133.553}, {-65, -686.517, 324.62}, {65, -686.517, 328.97},
                    {65, -354.934, 202.171},  {-65, -354.934, 197.822}};
  shape.faces = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  Project p = project();
  p.solids = {solid("B2", shape, 120)};
  const BlockSystem system = build(p);
  expect_sound(system, system.solids_volume);
  EXPECT_NEAR(system.solids_volume, 2770352, 100);
  const auto& nodes = system.blocks[0].mesh.nodes;
  for (const Vec3& vertex : shape.vertices) {
    double nearest = 1e9;
    for (const Vec3& node : nodes) nearest = std::min(nearest, (node - vertex).norm());
    EXPECT_LT(nearest, 2e-3);
  }
}

}  // namespace
}  // namespace talus
