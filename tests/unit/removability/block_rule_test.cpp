#include "removability/block_rule.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "support/small_scenes.hpp"

namespace talus {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

/// On a fixed floor a row: a cube, a slab that lies flat, a column; a plate apart from them leans on nothing.
struct Row {
  Project project;
  BlockSystem system;
  std::vector<BlockFacts> facts;

  Row() {
    project.materials = {{"rock", 2500, 5e9, 0.2}, {"clay", 1900, 1e8, 0.3}};
    project.joints.resize(2);
    project.joints[0].name = "bedding";
    project.joints[0].friction_angle = 30;
    project.joints[1].name = "cross";
    project.joints[1].friction_angle = 20;
    project.default_joint = "bedding";
    system.joint_names = {"bedding", "cross"};
    system.blocks = {test::box_block("floor", Vec3(-5, -5, -1), Vec3(15, 5, 0), BodyKind::fixed),
                     test::box_block("Roof 1", Vec3(0, 0, 0), Vec3(1, 1, 1)),
                     test::box_block("Roof 2", Vec3(1, 0, 0), Vec3(4, 1, 0.5), BodyKind::rigid),
                     test::box_block("wall.12", Vec3(4, 0, 0), Vec3(5, 1, 4)),
                     test::box_block("plate", Vec3(10, 0, 10), Vec3(14, 4, 10.1), BodyKind::rigid)};
    system.blocks[3].material = 1;
    for (SurfaceTriangle& triangle : system.blocks[3].surface) triangle.joint = 1;
    for (std::size_t b = 0; b < system.blocks.size(); ++b) system.blocks[b].solid = static_cast<int>(b) / 2;
    facts = block_facts(project, system);
  }
  std::vector<int> by(const BlockRule& rule) const { return blocks_by(rule, system, facts); }
};

TEST(BlockRule, OfVolumeLeavesTheLimitOut) {
  const Row row;  // 200, 1, 1.5, 4 and 1.6 m³
  EXPECT_THAT(row.by(ByVolume{Side::below, 1.5}), ElementsAre(1));
  EXPECT_THAT(row.by(ByVolume{Side::above, 1.5}), ElementsAre(0, 3, 4));
}

TEST(BlockRule, OfThicknessIsThatOfAPlate) {
  // 2 V / A: of the plate 3.2 / 33.6 = 0.095, of the cube 1/3, of the slab 0.3
  EXPECT_THAT(Row().by(ByThickness{0.1}), ElementsAre(4));
  EXPECT_THAT(Row().by(ByThickness{0.31}), ElementsAre(2, 4));
}

TEST(BlockRule, OfAPlaneLooksWhereTheCentroidIs) {
  const Row row;
  EXPECT_THAT(row.by(ByPlane{.side = Side::below, .through = Vec3(0, 0, 0.4)}), ElementsAre(0, 2));
  EXPECT_THAT(row.by(ByPlane{.side = Side::above, .through = Vec3(0, 0, 1.9)}), ElementsAre(3, 4));
  // An upright plane at x = 3; the length of the normal does not matter.
  EXPECT_THAT(row.by(ByPlane{Side::above, Vec3(3, 0, 0), Vec3(7, 0, 0)}), ElementsAre(0, 3, 4));
}

TEST(BlockRule, OfAJointAndOfAFreeFaceLookAtFaces) {
  const Row row;
  EXPECT_THAT(row.by(ByJoint{1}), ElementsAre(3));
  EXPECT_THAT(row.by(ByJoint{0}), ElementsAre(0, 1, 2, 3)) << "the default joint between them";
  EXPECT_THAT(row.by(ByFreeFace{}), ElementsAre(0, 1, 2, 3, 4));
}

TEST(BlockRule, OfRemovabilityKnowsWayAndFactor) {
  Row row;
  EXPECT_THAT(row.by(ByRemovability{}), ElementsAre(1, 2, 3, 4)) << "fixed blocks never leave";
  EXPECT_THAT(row.by(ByRemovability{.mode = Leaving::falls}), ElementsAre(4));
  EXPECT_THAT(row.by(ByRemovability{.mode = Leaving::stable}), ElementsAre(1, 2, 3));
  // A lean of 25° towards +y: F = tan φ / tan 25°, 1.24 on bedding, 0.78 under the wall that lies on the other joint.
  row.project.gravity = 9.81 * Vec3(0, std::sin(0.436332), -std::cos(0.436332));
  for (SurfaceTriangle& triangle : row.system.blocks[0].surface) triangle.joint = 1;
  row.system.blocks[1].surface = row.system.blocks[3].surface;
  row.facts = block_facts(row.project, row.system);
  EXPECT_THAT(row.by(ByRemovability{.mode = Leaving::slides_on_one, .factor_below = 1}), ElementsAre(1, 3));
  EXPECT_THAT(row.by(ByRemovability{.factor_below = 1.3}), ElementsAre(1, 2, 3, 4)) << "nothing holds the plate";
}

TEST(BlockRule, OfBodyMaterialAndSolidAreThoseOfTheBlock) {
  const Row row;
  EXPECT_THAT(row.by(ByBody{BodyKind::rigid}), ElementsAre(2, 4));
  EXPECT_THAT(row.by(ByMaterial{1}), ElementsAre(3));
  EXPECT_THAT(row.by(BySolid{1}), ElementsAre(2, 3));
}

TEST(BlockRule, OfANameKnowsStarsAndQuestionMarks) {
  const Row row;
  EXPECT_THAT(row.by(ByName{"roof *"}), ElementsAre(1, 2));
  EXPECT_THAT(row.by(ByName{"*1*"}), ElementsAre(1, 3));
  EXPECT_THAT(row.by(ByName{"roof ?"}), ElementsAre(1, 2));
  EXPECT_THAT(row.by(ByName{"wall.?"}), IsEmpty());
  EXPECT_THAT(row.by(ByName{"wall.??"}), ElementsAre(3));
  EXPECT_THAT(row.by(ByName{"L"}), ElementsAre(0, 3, 4)) << "without stars it is looked for anywhere";
  EXPECT_THAT(row.by(ByName{"f*l*r"}), ElementsAre(0));
}

TEST(Combination, IsThatOfSets) {
  const std::vector<int> selected{1, 2, 5}, found{2, 3};
  EXPECT_THAT(combined(selected, found, Combination::replace), ElementsAre(2, 3));
  EXPECT_THAT(combined(selected, found, Combination::add), ElementsAre(1, 2, 3, 5));
  EXPECT_THAT(combined(selected, found, Combination::remove), ElementsAre(1, 5));
  EXPECT_THAT(combined(selected, found, Combination::within), ElementsAre(2));
  EXPECT_THAT(inverted(selected, 6), ElementsAre(0, 3, 4));
}

TEST(Neighbours, OfASelectionAreAddedOneRingATime) {
  const Row row;
  EXPECT_THAT(grown({1}, row.facts), ElementsAre(0, 1, 2));
  EXPECT_THAT(grown({4}, row.facts), ElementsAre(4));
}

TEST(JoiningPairs, LeadFromBlockToBlock) {
  const Row row;
  EXPECT_THAT(joining_pairs({1, 2, 3}, row.facts), ElementsAre(Pair(1, 2), Pair(2, 3)));
  EXPECT_THAT(joining_pairs({1, 3}, row.facts), IsEmpty()) << "they do not touch";
  EXPECT_THAT(joining_pairs({1}, row.facts), IsEmpty());
}

}  // namespace
}  // namespace talus
