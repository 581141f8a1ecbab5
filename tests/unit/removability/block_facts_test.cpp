#include "removability/block_facts.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "base/units.hpp"
#include "support/small_scenes.hpp"

namespace talus {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::IsEmpty;

Project two_joints() {
  Project project;
  project.materials = {{"rock", 2500, 5e9, 0.2}};
  project.joints.resize(2);
  project.joints[0].name = "rough";
  project.joints[0].friction_angle = 40;
  project.joints[0].cohesion = 1e4;
  project.joints[1].name = "smooth";
  project.joints[1].friction_angle = 20;
  project.default_joint = "rough";
  return project;
}

/// A slab on a floor, and a wall beside the slab that covers half of its side.
BlockSystem slab_beside_a_wall() {
  BlockSystem system;
  system.joint_names = {"rough", "smooth"};
  system.blocks = {test::box_block("floor", Vec3(-5, -5, -1), Vec3(5, 5, 0), BodyKind::fixed),
                   test::box_block("slab", Vec3(0, 0, 0), Vec3(2, 1, 1)),
                   test::box_block("wall", Vec3(2, 0, 0), Vec3(3, 1, 0.5))};
  return system;
}

TEST(BlockFacts, TellsFacesNeighboursAndFreeArea) {
  const std::vector<BlockFacts> facts = block_facts(two_joints(), slab_beside_a_wall());
  EXPECT_EQ(facts[1].faces, 6);
  EXPECT_EQ(facts[1].free_faces, 4);
  EXPECT_THAT(facts[1].neighbours, ElementsAre(0, 2));
  EXPECT_THAT(facts[1].area, DoubleNear(10, 1e-12));
  EXPECT_THAT(facts[1].free_area, DoubleNear(10 - 2 - 0.5, 1e-12));
  EXPECT_THAT(facts[1].joints, ElementsAre(0));
  EXPECT_TRUE(facts[0].fixed);
  EXPECT_EQ(facts[1].leaving.leaving, Leaving::stable);
}

/// A box that slides on a floor when gravity leans: F = tan φ / tan lean + c A / (W sin lean); on the joint of the cut
/// that made both faces, of the interface, of the default.
TEST(BlockFacts, FactorIsThatOfTheJointBetweenTheFaces) {
  Project project = two_joints();
  BlockSystem system = slab_beside_a_wall();
  system.blocks.pop_back();
  const double lean = radians(30), weight = 2500 * 2 * 9.81;
  project.gravity = 9.81 * Vec3(std::sin(lean), 0, -std::cos(lean));
  const auto slab = [&] { return block_facts(project, system)[1]; };

  EXPECT_EQ(slab().leaving.leaving, Leaving::slides_on_one);
  EXPECT_THAT(slab().slides_on, ElementsAre("rough"));
  EXPECT_NEAR(slab().leaving.factor.value(),
              std::tan(radians(40)) / std::tan(lean) + 1e4 * 2 / (weight * std::sin(lean)), 1e-12);

  project.interfaces = {{{"slab", "floor"}, "smooth"}};
  EXPECT_NEAR(slab().leaving.factor.value(), std::tan(radians(20)) / std::tan(lean), 1e-12);

  project.interfaces.clear();
  for (Block& block : system.blocks)
    for (SurfaceTriangle& triangle : block.surface) triangle.joint = 1;
  EXPECT_THAT(slab().slides_on, ElementsAre("smooth"));
}

/// A box in a hole that it fits on all sides but the top is pulled straight up, and its weight keeps it there.
TEST(BlockFacts, ABoxInAPitIsRemovableAndStable) {
  BlockSystem system;
  system.blocks = {test::box_block("box", Vec3(0, 0, 0), Vec3(1, 1, 1)),
                   test::box_block("floor", Vec3(-1, -1, -1), Vec3(2, 2, 0)),
                   test::box_block("west", Vec3(-1, -1, 0), Vec3(0, 2, 1)),
                   test::box_block("east", Vec3(1, -1, 0), Vec3(2, 2, 1)),
                   test::box_block("south", Vec3(0, -1, 0), Vec3(1, 0, 1)),
                   test::box_block("north", Vec3(0, 1, 0), Vec3(1, 2, 1))};
  EXPECT_EQ(block_facts(two_joints(), system)[0].leaving.leaving, Leaving::stable);
  system.blocks.push_back(test::box_block("lid", Vec3(-1, -1, 1), Vec3(2, 2, 2)));
  const BlockFacts box = block_facts(two_joints(), system)[0];
  EXPECT_EQ(box.leaving.leaving, Leaving::enclosed);
  EXPECT_EQ(box.free_faces, 0);
  EXPECT_NEAR(box.free_area, 0, 1e-12);
}

TEST(BlockFacts, SlendernessGrowsWithTheRatioOfTheSides) {
  const Block cube = test::box_block("cube", Vec3(0, 0, 0), Vec3(1, 1, 1));
  EXPECT_NEAR(slenderness(cube, 6), 2, 1e-12);
  const double thin = 1.0 / 40;
  const Block plate = test::box_block("plate", Vec3(0, 0, 0), Vec3(1, 1, thin));
  EXPECT_GT(slenderness(plate, 2 + 4 * thin), sliver_slenderness);
}

}  // namespace
}  // namespace talus
