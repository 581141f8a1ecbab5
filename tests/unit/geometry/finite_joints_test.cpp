#include <gmock/gmock.h>

#include <numbers>

#include "orientation/drawn_planes.hpp"
#include "rock.hpp"

// Joints that end: discs, polygons, planes that end at others, networks.
namespace talus {
namespace {

using namespace rock;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

Project wide_cube(double size = 5) {
  Project p = project();
  p.solids = {box("cube", {0, 0, 0}, {10, 10, 10}, size)};
  return p;
}

Cut disc(const std::string& joint, double dip, double dip_direction, const Vec3& centre, double radius) {
  Cut made = cut(joint, dip, dip_direction, centre);
  made.disc = {centre, radius};
  return made;
}

Cut polygon(const std::string& joint, double dip, double dip_direction, std::vector<Vec3> corners) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& corner : corners) sum += corner;
  Cut made = cut(joint, dip, dip_direction, sum / static_cast<double>(corners.size()));
  made.polygon = std::move(corners);
  return made;
}

Cut ending(Cut at, std::vector<std::string> joints) {
  at.ends_at = std::move(joints);
  return at;
}

std::vector<double> volumes_of(const BlockSystem& system) {
  std::vector<double> volumes;
  for (const Block& b : system.blocks) volumes.push_back(std::round(b.volume * 1e6) / 1e6);
  std::sort(volumes.begin(), volumes.end());
  return volumes;
}

TEST(FiniteJoints, ADiscLargerThanTheRockCutsLikeAPlane) {
  Project plane = wide_cube(), round = wide_cube();
  plane.cuts = {cut("J2", 35, 120, {5, 5, 5})};
  round.cuts = {disc("J2", 35, 120, {5, 5, 5}, 12)};
  const BlockSystem a = build(plane), b = build(round);
  EXPECT_EQ(volumes_of(a), volumes_of(b));
  EXPECT_NEAR(joint_areas(a.blocks[0])[1], joint_areas(b.blocks[0])[1], 1e-9);
  EXPECT_TRUE(a.endings.empty());
  ASSERT_EQ(b.endings.size(), 1u);
  EXPECT_EQ(b.endings[0].joints, 1);
  EXPECT_EQ(b.endings[0].dividing, 1);
  expect_sound(b, 1000);
}

TEST(FiniteJoints, ADiscInsideTheRockDividesNothingAndIsTold) {
  Project p = wide_cube();
  p.cuts = {disc("J1", 35, 120, {5, 5, 5}, 2)};
  const BlockSystem system = build(p);
  ASSERT_EQ(system.blocks.size(), 1u);
  EXPECT_EQ(system.blocks[0].mesh.nodes.size(), build(wide_cube()).blocks[0].mesh.nodes.size()) << "it leaves no mark";
  ASSERT_EQ(system.endings.size(), 1u);
  EXPECT_EQ(system.endings[0].joints, 1);
  EXPECT_EQ(system.endings[0].dividing, 0);
}

TEST(FiniteJoints, ADiscThatCutsInFromAFaceDividesNothingAndLeavesNoMark) {
  Project p = wide_cube();
  p.cuts = {disc("J1", 90, 90, {5, 5, 10}, 3)};
  const BlockSystem system = build(p);
  ASSERT_EQ(system.blocks.size(), 1u);
  EXPECT_EQ(system.blocks[0].mesh.nodes.size(), build(wide_cube()).blocks[0].mesh.nodes.size());
  expect_sound(system, 1000);
}

TEST(FiniteJoints, ThatMissAllRockAreAnError) {
  Project p = wide_cube();
  p.cuts = {disc("J1", 0, 0, {5, 5, 12}, 2)};
  EXPECT_THAT(error_of(p), StartsWith("cut 1 (J1): misses every solid"));
}

TEST(FiniteJoints, APolygonCutsOffACornerAndIsNoWiderThanItself) {
  // A triangle through three edges of the cube at 4 m from its corner cuts off a tetrahedron of 4³/6.
  Project p = wide_cube();
  const double dip = std::acos(1 / std::sqrt(3.0)) * 180 / std::numbers::pi;
  const double middle = 26.0 / 3;
  const auto triangle = [&](double scale) {  // about the middle of the section, whose corners are at 6 and 10
    const double low = middle + scale * (6 - middle), high = middle + scale * (10 - middle);
    return polygon("J2", dip, 45, {{low, high, high}, {high, low, high}, {high, high, low}});
  };
  for (const double scale : {1.0, 3.0}) {
    p.cuts = {triangle(scale)};
    EXPECT_THAT(volumes_of(build(p)),
                ElementsAre(testing::DoubleNear(64.0 / 6, 1e-5), testing::DoubleNear(1000 - 64.0 / 6, 1e-5)));
  }
  p.cuts = {triangle(0.5)};
  EXPECT_THAT(volumes_of(build(p)), ElementsAre(1000));
}

TEST(FiniteJoints, TwoHalfPlanesThatEndAtEachOtherMakeAnEll) {
  // Level below x = 5 of the cube, upright above z = 5: the upper west quarter comes off.
  Project p = wide_cube();
  p.cuts = {ending(cut("J1", 0, 0, {2, 5, 5}), {"J2"}), ending(cut("J2", 90, 90, {5, 5, 8}), {"J1"})};
  const BlockSystem system = build(p);
  EXPECT_THAT(volumes_of(system), ElementsAre(250, 750));
  const Block& quarter = system.blocks[system.blocks[0].volume < 500 ? 0 : 1];
  EXPECT_NEAR(joint_areas(quarter)[0], 50, 1e-9);
  EXPECT_NEAR(joint_areas(quarter)[1], 50, 1e-9);
  for (const Vec3& node : quarter.mesh.nodes) {
    EXPECT_LE(node.x(), 5 + 1e-12);
    EXPECT_GE(node.z(), 5 - 1e-12);
  }
  expect_sound(system, 1000);
}

TEST(FiniteJoints, ThatEndAtOneCutStayOnTheSideOfTheirPoint) {
  Project p = wide_cube();
  p.cuts = {cut("J1", 0, 0, {5, 5, 4}), ending(cut("J2", 90, 90, {3, 5, 8}), {"J1"})};
  EXPECT_THAT(volumes_of(build(p)), ElementsAre(180, 400, 420));
  p.cuts[1].through = {3, 5, 1};
  EXPECT_THAT(volumes_of(build(p)), ElementsAre(120, 280, 600));
  p.cuts[1].through = {3, 5, 4};
  EXPECT_THAT(error_of(p), StartsWith("cut 2 (J2): its point lies on cut 1 (J1), where it is to end"));
}

TEST(FiniteJoints, OfASetEndAtTheBedsAroundThem) {
  // Cross joints in the middle of three beds alone.
  Project p = wide_cube();
  Cut bedding = cut("J1", 0, 0, {5, 5, 3}), cross = ending(cut("J2", 90, 90, {2, 5, 5}), {"J1"});
  bedding.spacing = 4;
  bedding.count = 2;  // z = 3, 7
  cross.spacing = 3;
  cross.count = 3;  // x = 2, 5, 8
  p.cuts = {bedding, cross};
  const BlockSystem system = build(p);
  EXPECT_THAT(volumes_of(system), ElementsAre(80, 80, 120, 120, 300, 300));
  ASSERT_EQ(system.endings.size(), 1u);
  EXPECT_EQ(system.endings[0].cut, 1);
  EXPECT_EQ(system.endings[0].dividing, 3);
}

TEST(FiniteJoints, EndAtADiscOnlyWhereTheyMeetIt) {
  Project p = wide_cube();
  p.cuts = {disc("J1", 0, 0, {2, 2, 4}, 1), ending(cut("J2", 90, 90, {7, 5, 8}), {"J1"})};
  EXPECT_THAT(volumes_of(build(p)), ElementsAre(300, 700)) << "the disc is elsewhere";
}

TEST(FiniteJoints, ParallelDiscsAreAsFarApartAsTheSpacing) {
  Project p = wide_cube();
  p.cuts = {disc("J1", 0, 0, {5, 5, 2}, 9)};
  p.cuts[0].spacing = 3;
  p.cuts[0].count = 3;
  EXPECT_THAT(volumes_of(build(p)), ElementsAre(200, 200, 300, 300));
}

TEST(FiniteJoints, GiveTheirJointToNoFaceOutsideThem) {
  // Two discs on one plane, with different joints; each divides one of two halves of the cube.
  Project p = wide_cube();
  p.cuts = {cut("J3", 90, 90, {5, 0, 0}), ending(disc("J1", 0, 0, {1, 5, 5}, 9), {"J3"}),
            ending(disc("J2", 0, 0, {9, 5, 5}, 9), {"J3"})};
  const BlockSystem system = build(p);
  EXPECT_THAT(volumes_of(system), ElementsAre(250, 250, 250, 250));
  for (const Block& b : system.blocks) {
    auto areas = joint_areas(b);
    double west = 1e9;
    for (const Vec3& node : b.mesh.nodes) west = std::min(west, node.x());
    EXPECT_NEAR(areas[0], west < 1 ? 50 : 0, 1e-9);
    EXPECT_NEAR(areas[1], west < 1 ? 0 : 50, 1e-9);
  }
}

TEST(FiniteJoints, BetweenSolidsThatTouchGiveTheirJointToTheirOwnPart) {
  Project p = project();
  p.solids = {box("base", {0, 0, 0}, {10, 10, 2}, 4), box("top", {0, 0, 2}, {10, 10, 4}, 4)};
  p.cuts = {polygon("J3", 0, 0, {{-1, -1, 2}, {4, -1, 2}, {4, 11, 2}, {-1, 11, 2}})};
  const BlockSystem system = build(p);
  ASSERT_EQ(system.blocks.size(), 2u);
  for (const Block& b : system.blocks) EXPECT_NEAR(joint_areas(b)[2], 40, 1e-9);
}

TEST(FiniteJoints, OfANetworkCutWhereTheyAreDrawn) {
  // Level discs of 9 m about the middle of the cube, whose corners are 7 m from it: each divides all of it.
  Project p = wide_cube();
  Cut network = cut("J1", 0, 0, {5, 5, 5});
  network.network = JointNetwork{{{4, 4, 1}, {6, 6, 9}}, 45, 9, RadiusLaw::equal, {}};
  network.seed = 4;
  p.cuts = {network};
  std::vector<double> heights{0, 10};
  for (const Cut& disc : single_planes(network)) heights.push_back(disc.through.z());
  std::sort(heights.begin(), heights.end());
  ASSERT_EQ(heights.size(), 2 + 6u);  // 45 · 32 m² over 81 π
  std::vector<double> volumes;
  for (std::size_t i = 0; i + 1 < heights.size(); ++i)
    volumes.push_back(std::round(1e8 * (heights[i + 1] - heights[i])) / 1e6);
  std::sort(volumes.begin(), volumes.end());
  const BlockSystem system = build(p);
  EXPECT_THAT(volumes_of(system), testing::Pointwise(testing::DoubleNear(1e-5), volumes));
  ASSERT_EQ(system.endings.size(), 1u);
  EXPECT_EQ(system.endings[0].joints, 6);
  EXPECT_EQ(system.endings[0].dividing, 6);
  expect_sound(system, 1000);
}

TEST(FiniteJoints, OfANetworkMayAllMiss) {
  Project p = wide_cube();
  Cut network = cut("J1", 30, 0, {100, 100, 100});
  network.network = JointNetwork{{{90, 90, 90}, {110, 110, 110}}, 0.01, 2, RadiusLaw::equal, {}};
  p.cuts = {network};
  const BlockSystem system = build(p);
  EXPECT_EQ(system.blocks.size(), 1u);
  EXPECT_EQ(system.endings[0].dividing, 0);
}

}  // namespace
}  // namespace talus
