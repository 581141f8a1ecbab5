#include <gmock/gmock.h>

#include "rock.hpp"

// Convex solids whose blocks do not deform are cut as convex cells, without OpenCASCADE: the same promises as for all
// others, and the same blocks.
namespace talus {
namespace {

using namespace rock;
using testing::HasSubstr;
using testing::StartsWith;

Cut set(const std::string& joint, double dip, double dip_direction, const Vec3& through, double spacing, int count) {
  Cut made = cut(joint, dip, dip_direction, through);
  made.spacing = spacing;
  made.count = count;
  return made;
}

Project cube(BodyKind body) {
  Project p = project();
  p.solids = {box("cube", {0, 0, 0}, {10, 10, 10})};
  p.solids[0].body = body;
  p.cuts = {set("J1", 30, 70, {5, 5, 2}, 2, 3), set("J2", 80, 200, {5, 8, 5}, 2.5, 3), cut("J3", 70, 300, {4, 5, 5})};
  return p;
}

TEST(ConvexSolids, GiveTheBlocksThatOpenCascadeGives) {
  const BlockSystem rigid = build(cube(BodyKind::rigid)), meshed = build(cube(BodyKind::tetrahedra));
  expect_sound(rigid, 1000);
  ASSERT_EQ(rigid.blocks.size(), meshed.blocks.size());
  EXPECT_GT(rigid.blocks.size(), 20u);
  for (std::size_t b = 0; b < rigid.blocks.size(); ++b) {
    EXPECT_EQ(rigid.blocks[b].name, meshed.blocks[b].name);
    EXPECT_NEAR(rigid.blocks[b].volume, meshed.blocks[b].volume, 1e-9);
    const auto own = joint_areas(rigid.blocks[b]), other = joint_areas(meshed.blocks[b]);
    ASSERT_EQ(own.size(), other.size()) << rigid.blocks[b].name;
    for (const auto& [joint, area] : own) EXPECT_NEAR(area, other.at(joint), 1e-8);
  }
}

TEST(ConvexSolids, StandOnTheirCornersWhateverTheyAreHeldBy) {
  for (const BodyKind body : {BodyKind::rigid, BodyKind::affine, BodyKind::fixed}) {
    Project p = cube(body);
    p.cuts.clear();
    const BlockSystem system = build(p);
    expect_sound(system, 1000);
    EXPECT_EQ(system.blocks[0].mesh.nodes.size(), 9u) << "its corners and its centroid";
    EXPECT_EQ(system.blocks[0].mesh.tetrahedra.size(), 12u) << "one on each triangle";
  }
}

TEST(ConvexSolids, KeepTheJointOfAPlaneThatLiesOnAFace) {
  Project p = cube(BodyKind::rigid);
  p.cuts = {cut("J1", 0, 0, {0, 0, 5}), cut("J2", 0.05, 90, {5, 5, 10 - 1e-5}), cut("J1", 0, 0, {3, 3, 5})};
  const BlockSystem system = build(p);
  ASSERT_EQ(system.blocks.size(), 2u);
  EXPECT_NEAR(joint_areas(system.blocks[1])[1], 100, 1e-9);
  p.cuts[2].joint = "J3";
  EXPECT_THAT(error_of(p), StartsWith("cut 3 (J3): lies on the same plane of solid cube as cut 1 (J1)"));
}

TEST(ConvexSolids, MayTouchAndNotOverlap) {
  Project p = cube(BodyKind::rigid);
  p.cuts.clear();
  p.solids.push_back(box("beside", {10, 0, 0}, {12, 10, 10}));
  p.solids.push_back(box("on top", {2, 2, 10}, {4, 4, 12}));
  p.solids[1].body = BodyKind::rigid;  // the other one is meshed
  EXPECT_EQ(build(p).blocks.size(), 3u);
  p.solids[1].move = {-1, 0, 0};
  EXPECT_THAT(error_of(p), StartsWith("solid cube: overlaps solid beside by 100 m³"));
  p.solids[1].move = {0, 0, 0};
  p.solids[2].move = {0, 0, -1};
  EXPECT_THAT(error_of(p), HasSubstr("overlaps solid on top by 4 m³"));
}

TEST(ConvexSolids, AreMeshedWhereABlockDeforms) {
  Project p = cube(BodyKind::rigid);
  p.cuts = {cut("J1", 0, 0, {0, 0, 5})};
  p.blocks = {{"upper", {5, 5, 7}, BodyKind::tetrahedra, {}, {}}};
  const BlockSystem system = build(p);
  expect_sound(system, 1000);
  EXPECT_GT(block(system, "upper").mesh.nodes.size(), 200u);
  EXPECT_LT(system.blocks[0].mesh.nodes.size(), 12u);
}

}  // namespace
}  // namespace talus
