#include <gmock/gmock.h>

#include "base/units.hpp"
#include "geometry/splinters_found.hpp"
#include "rock.hpp"

// What the project makes of the pieces that cutting leaves: excavated, merged, splinters dropped or merged.
namespace talus {
namespace {

using namespace rock;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

/// A column of 1 m × 1 m, cut level at z = 1, 3 and 6: pieces of 1, 2, 3 and 4 m³.
Project column() {
  Project p = project();
  p.solids = {box("column", {0, 0, 0}, {1, 1, 10}, 1)};
  p.cuts = {cut("J1", 0, 0, {0, 0, 1}), cut("J2", 0, 0, {0, 0, 3}), cut("J3", 0, 0, {0, 0, 6})};
  return p;
}

BlockOverride at(const std::string& name, double height) {
  BlockOverride wanted;
  wanted.name = name;
  wanted.at = {0.5, 0.5, height};
  return wanted;
}

Merge merge(double height, double with) { return {{0.5, 0.5, height}, {0.5, 0.5, with}}; }

std::vector<std::string> names_of(const BlockSystem& system) {
  std::vector<std::string> names;
  for (const Block& b : system.blocks) names.push_back(b.name);
  return names;
}

double sum_of(const BlockSystem& system) {
  double sum = 0;
  for (const Block& b : system.blocks) sum += b.volume;
  return sum;
}

TEST(KeptBlocks, ARemovedBlockIsLeftOutAndTheOthersKeepTheirNumbers) {
  Project p = column();
  p.blocks = {at("gone", 2)};
  p.blocks[0].removed = true;
  const BlockSystem system = build(p);
  EXPECT_THAT(names_of(system), ElementsAre("column.1", "column.3", "column.4"));
  EXPECT_NEAR(system.excavated_volume, 2, 1e-9);
  EXPECT_NEAR(sum_of(system) + system.excavated_volume, system.solids_volume, 1e-9);
  EXPECT_NEAR(joint_areas(block(system, "column.1"))[0], 1, 1e-9) << "its face is free, and still a face of J1";
}

TEST(KeptBlocks, NothingMayNameARemovedBlock) {
  Project p = column();
  p.blocks = {at("gone", 2)};
  p.blocks[0].removed = true;
  p.monitors = {{"P1", "gone", {0.5, 0.5, 2}}};
  EXPECT_THAT(error_of(p), StartsWith("/monitors/0/block: block 'gone' is removed"));
  p.monitors[0].block = "column.2";
  EXPECT_THAT(error_of(p), StartsWith("/monitors/0/block: no block is called 'column.2'"));
}

TEST(KeptBlocks, NotEverythingMayBeRemoved) {
  Project p = project();
  p.solids = {box("cube", {0, 0, 0}, {1, 1, 1}, 1)};
  p.blocks = {at("all", 0.5)};
  p.blocks[0].removed = true;
  EXPECT_THAT(error_of(p), StartsWith("/blocks: no block is left"));
}

TEST(KeptBlocks, AMergeUndoesACut) {
  Project p = column();
  p.merges = {merge(2, 0.5)};
  p.blocks = {at("first", 2)};
  const BlockSystem system = build(p);
  EXPECT_THAT(names_of(system), ElementsAre("first", "column.3", "column.4"));
  const Block& merged = block(system, "first");
  EXPECT_NEAR(merged.volume, 3, 1e-12);
  auto areas = joint_areas(merged);
  EXPECT_EQ(areas.count(0), 0u) << "the cut between the two is gone";
  EXPECT_NEAR(areas[1], 1, 1e-9) << "the one above is not";
  EXPECT_NEAR(areas[-1], 1 + 4 * 3, 1e-9);
  expect_sound(system, 10);
}

TEST(KeptBlocks, MergesMakeAnEllOfThreePieces) {
  // A cube of four quarters; without the upper one at the east side it is an L of three.
  Project p = project();
  p.solids = {box("cube", {0, 0, 0}, {2, 2, 2}, 1)};
  p.cuts = {cut("J1", 0, 0, {0, 0, 1}), cut("J2", 90, 90, {1, 0, 0})};
  p.merges = {{{0.5, 1, 0.5}, {0.5, 1, 1.5}}, {{0.5, 1, 1.5}, {1.5, 1, 0.5}}};
  const BlockSystem system = build(p);
  ASSERT_EQ(system.blocks.size(), 2u);
  EXPECT_NEAR(system.blocks[0].volume, 6, 1e-12);
  EXPECT_NEAR(joint_areas(system.blocks[0])[0], 2, 1e-9);
  EXPECT_NEAR(joint_areas(system.blocks[0])[1], 2, 1e-9);
  expect_sound(system, 8);
}

TEST(KeptBlocks, WhatIsSaidOfTheFirstOfAMergeCounts) {
  Project p = column();
  p.merges = {merge(2, 0.5)};
  p.blocks = {at("second", 0.5)};
  p.blocks[0].body = BodyKind::fixed;
  EXPECT_EQ(block(build(p), "second").body, BodyKind::fixed) << "nothing is said of the first";
  p.blocks.push_back(at("first", 2));
  BlockSystem system = build(p);
  EXPECT_THAT(names_of(system), ElementsAre("first", "column.3", "column.4"));
  EXPECT_EQ(system.blocks[0].body, BodyKind::tetrahedra);
  p.blocks[0].removed = true;
  EXPECT_THAT(error_of(p), StartsWith("block override 1 (second): is removed and merged with"));
  p.blocks.erase(p.blocks.begin());
  p.blocks[0].removed = true;
  EXPECT_NEAR(build(p).excavated_volume, 3, 1e-12);
}

TEST(KeptBlocks, MergesThatCannotBeAreNamedWithBothPoints) {
  Project p = column();
  p.merges = {merge(0.5, 8)};
  EXPECT_THAT(error_of(p), AllOf(StartsWith("merge 1: its blocks column.1, at (0.5, 0.5, 0.5), and column.4, at"),
                                 HasSubstr("share no face")));
  p.merges = {merge(0.5, 2), merge(2, 20)};
  EXPECT_THAT(error_of(p), StartsWith("merge 2: its point \"with\" lies in no block"));
  p.merges = {merge(1, 2)};
  EXPECT_THAT(error_of(p), StartsWith("merge 1: its point \"at\" lies on the border of column.1 and column.2"));
  p.solids.push_back(box("beside", {1, 0, 0}, {2, 1, 10}, 1));
  p.merges = {{{0.5, 0.5, 0.5}, {1.5, 0.5, 0.5}}};
  EXPECT_THAT(error_of(p), AllOf(StartsWith("merge 1: its blocks column.1, at (0.5, 0.5, 0.5), and beside.1, at (1.5"),
                                 HasSubstr("belong to different solids; unite the solids with \"combine\"")));
}

/// Eight cubes, far from the origin: the four below and two across a corner above are to be one, whose surface has four
/// triangles at the upright edge in the middle.
TEST(KeptBlocks, ABlockThatTouchesItselfAlongAnEdgeIsNamedWithTheEdge) {
  Project p = project();
  const Vec3 corner(1000, 2000, 0);
  p.solids = {box("cube", corner, corner + Vec3(2, 2, 2), 1)};
  p.cuts = {cut("J1", 90, 90, corner + Vec3(1, 1, 1)), cut("J2", 90, 0, corner + Vec3(1, 1, 1)),
            cut("J3", 0, 0, corner + Vec3(1, 1, 1))};
  const auto joined = [&](const Vec3& at, const Vec3& with) { p.merges.push_back({corner + at, corner + with}); };
  joined({0.5, 0.5, 0.5}, {1.5, 0.5, 0.5});
  joined({0.5, 0.5, 0.5}, {0.5, 1.5, 0.5});
  joined({0.5, 0.5, 0.5}, {1.5, 1.5, 0.5});
  joined({0.5, 0.5, 0.5}, {0.5, 0.5, 1.5});
  EXPECT_EQ(build(p).blocks.size(), 4U);
  joined({0.5, 0.5, 0.5}, {1.5, 1.5, 1.5});
  EXPECT_THAT(error_of(p), AllOf(HasSubstr("touches itself along an edge at (1001, 2001, 1.5); merge it with")));
}

/// The cut takes 10⁻⁴ m off an edge of a cube of 10 m: a prism of 10 · 10⁻⁸ / 2 m³.
Project cube_with_a_splinter() {
  Project p = project();
  p.solids = {box("cube", {0, 0, 0}, {10, 10, 10}, 5)};
  p.cuts = {cut("J1", 45, 90, {10, 5, 9.9999})};
  return p;
}

TEST(Splinters, AreAllToldWithPlaceThicknessAndVolume) {
  Project p = cube_with_a_splinter();
  p.cuts.push_back(cut("J2", 45, 270, {0, 5, 9.9999}));
  p.splinters.rule = SplinterRule::refuse;
  try {
    build(p);
    FAIL() << "no error";
  } catch (const SplintersFound& error) {
    EXPECT_THAT(error.what(), AllOf(StartsWith("solid cube: the cuts leave 2 splinters: "), HasSubstr("(5e-08 m³)")));
    ASSERT_EQ(error.splinters().size(), 2u);
    for (const Splinter& splinter : error.splinters()) {
      EXPECT_EQ(splinter.fate, Splinter::Fate::refused);
      EXPECT_NEAR(splinter.volume, 5e-8, 1e-12);
      EXPECT_NEAR(splinter.where.y(), 5, 1e-9);
      EXPECT_NEAR(splinter.thickness, 2 * 5e-8 / (10 * 1e-4 * (2 + std::sqrt(2))), 1e-8);
    }
    EXPECT_NEAR(error.splinters()[0].where.x(), 0, 1e-4);
    EXPECT_NEAR(error.splinters()[1].where.x(), 10, 1e-4);
  }
}

TEST(Splinters, AreDroppedAndToldWhereNothingIsSaidOfThem) {
  const Project p = cube_with_a_splinter();
  const BlockSystem system = build(p);
  EXPECT_THAT(names_of(system), ElementsAre("cube.1"));
  ASSERT_EQ(system.splinters.size(), 1u);
  EXPECT_EQ(system.splinters[0].fate, Splinter::Fate::dropped);
  EXPECT_NEAR(system.splinters[0].volume, 5e-8, 1e-12);
  EXPECT_NEAR(sum_of(system) + system.splinters[0].volume, system.solids_volume, 1e-9);
}

TEST(Splinters, AreMergedWithTheNeighbourThatTheyShareMostWith) {
  Project p = cube_with_a_splinter();
  p.cuts.push_back(cut("J2", 90, 0, {0, 3, 0}));  // 3 m of the edge south of it, 7 m north: two splinters
  p.splinters.rule = SplinterRule::merge;
  const BlockSystem system = build(p);
  ASSERT_EQ(system.blocks.size(), 2u);
  EXPECT_NEAR(system.blocks[0].volume, 300, 1e-9);
  EXPECT_NEAR(system.blocks[1].volume, 700, 1e-9);
  ASSERT_EQ(system.splinters.size(), 2u);
  for (const Splinter& splinter : system.splinters) {
    EXPECT_EQ(splinter.fate, Splinter::Fate::merged);
    const Block& into = block(system, splinter.merged_into);
    EXPECT_EQ(into.volume > 500, splinter.where.y() > 3);
  }
  expect_sound(system, 1000);
}

TEST(Splinters, AreWhatIsThinnerThanTheProjectSays) {
  Project p = column();  // the lowest piece is 2 · 1 / 6 m thick, the next 2 · 2 / 10
  p.splinters.rule = SplinterRule::refuse;
  p.splinters.thickness = 0.333;
  EXPECT_EQ(build(p).blocks.size(), 4u);
  p.splinters.thickness = 0.334;
  EXPECT_THAT(error_of(p), HasSubstr("leave a splinter 0.333 m thick around (0.5, 0.5, 0.5) (1 m³)"));
  p.splinters.rule = SplinterRule::merge;
  const BlockSystem system = build(p);
  EXPECT_THAT(names_of(system), ElementsAre("column.2", "column.3", "column.4"));
  EXPECT_NEAR(system.blocks[0].volume, 3, 1e-12);
}

TEST(Splinters, ThatAMergeMakesPartOfABlockAreNone) {
  Project p = cube_with_a_splinter();
  p.merges = {{{5, 5, 5}, {10 - 2e-5, 5, 10 - 2e-5}}};
  const BlockSystem system = build(p);
  EXPECT_EQ(system.blocks.size(), 1u);
  EXPECT_TRUE(system.splinters.empty());
  expect_sound(system, 1000);
}

/// A corner of 9 cm, 1.2e-4 m³, is cut off a cube of 10 m that is cut in two: some 2e-7 of the median.
Project cube_with_a_chip() {
  Project p = project();
  p.solids = {box("cube", {0, 0, 0}, {10, 10, 10}, 5)};
  p.cuts = {cut("J1", 0, 0, {0, 0, 5}), cut("J2", degrees(std::acos(1 / std::sqrt(3.0))), 45, {10, 10, 9.91})};
  return p;
}

TEST(Splinters, AreChipsThatAreSmallBesideTheBlocksOfTheirSolid) {
  const BlockSystem system = build(cube_with_a_chip());
  EXPECT_EQ(system.blocks.size(), 2u);
  ASSERT_EQ(system.splinters.size(), 1u);
  EXPECT_EQ(system.splinters[0].fate, Splinter::Fate::dropped);
  EXPECT_NEAR(system.splinters[0].volume, std::pow(0.09, 3) / 6, 1e-9);
  EXPECT_NEAR(sum_of(system) + system.splinters[0].volume, system.solids_volume, 1e-9);
}

TEST(Splinters, AreNoChipsThatTheProjectNamesOrAllows) {
  Project p = cube_with_a_chip();
  p.blocks = {at("chip", 0)};
  p.blocks[0].at = {9.98, 9.98, 9.98};
  EXPECT_NEAR(block(build(p), "chip").volume, std::pow(0.09, 3) / 6, 1e-9);
  p = cube_with_a_chip();
  p.splinters.chip_volume = 0;
  EXPECT_EQ(build(p).blocks.size(), 3u);
}

TEST(Splinters, WithoutANeighbourAreDropped) {
  Project p = project();
  p.solids = {box("cube", {0, 0, 0}, {1, 1, 1}, 1), box("leaf", {2, 0, 0}, {2.001, 1, 1}, 1)};
  p.splinters = {0.01, SplinterRule::merge};
  const BlockSystem system = build(p);
  EXPECT_THAT(names_of(system), ElementsAre("cube"));
  ASSERT_EQ(system.splinters.size(), 1u);
  EXPECT_EQ(system.splinters[0].fate, Splinter::Fate::dropped);
}

}  // namespace
}  // namespace talus
