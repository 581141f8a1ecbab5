#include "bodies/block_motion.hpp"

#include <gmock/gmock.h>

#include <Eigen/Geometry>

#include "base/error.hpp"
#include "support/small_scenes.hpp"

namespace talus {
namespace {

Project rock_project() {
  Project project;
  project.materials = {{"rock", 2600, 25e9, 0.24}};
  return project;
}

BlockSystem two_boxes() {
  BlockSystem system;
  system.blocks = {test::box_block("ground", Vec3(-5, -5, -1), Vec3(5, 5, 0), BodyKind::fixed),
                   test::box_block("B", Vec3(1, 2, 0), Vec3(3, 3, 1.5))};
  return system;
}

TEST(BlockMotion, FindsTranslationRotationAndVolumeChangeOfAMovedBlock) {
  const BlockSystem system = two_boxes();
  BodySet set(rock_project(), system);
  const Eigen::AngleAxisd turn(0.4, Vec3(1, 2, -1).normalized());
  const Vec3 centroid(2, 2.5, 0.75), shift(3, -1, 2);
  for (int n = set.bodies[1].first_node; n < set.bodies[1].first_node + 8; ++n) {
    set.nodes.position[n] = 1.01 * (turn * (set.nodes.reference[n] - centroid)) + centroid + shift;
    set.nodes.velocity[n] = Vec3(1, 2, 3);
  }
  const BlockMotion motion = block_motion(set, 1);
  EXPECT_LT((motion.displacement - shift).norm(), 1e-13);
  EXPECT_LT((motion.velocity - Vec3(1, 2, 3)).norm(), 1e-13);
  EXPECT_NEAR(motion.rotation, 0.4, 1e-12);
  EXPECT_NEAR(motion.relative_volume_change, std::pow(1.01, 3) - 1, 1e-12);
}

TEST(MaterialPoint, IsAWeightedMeanOfItsOwnBlocksNodes) {
  const BlockSystem system = two_boxes();
  const BodySet set(rock_project(), system);
  const Vec3 where(1.7, 2.6, 0.9);
  const MaterialPoint point = material_point(system, "B", where, 0, "/monitors/0");
  EXPECT_EQ(point.body, 1);
  EXPECT_LT((point.at(set.nodes.reference) - where).norm(), 1e-14);
}

TEST(MaterialPoint, OutsideItsBlockOrInNoBlockIsAnErrorWithItsPlace) {
  const BlockSystem system = two_boxes();
  EXPECT_NO_THROW(material_point(system, "B", Vec3(1, 2, -1e-9), 1e-6, "/monitors/0"));
  try {
    material_point(system, "B", Vec3(1, 2, -0.5), 1e-6, "/monitors/0");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.place(), "/monitors/0");
    EXPECT_EQ(error.problem(), "the point lies outside block 'B'");
  }
  EXPECT_THROW(material_point(system, "nobody", Vec3(1, 2, 0), 1e-6, "/monitors/0"), InputError);
}

TEST(BodySet, GivesDofBlocksToMovableNodesAlone) {
  const BlockSystem system = two_boxes();
  const BodySet set(rock_project(), system);
  EXPECT_EQ(set.unknowns(), 24);
  EXPECT_EQ(set.elements.size(), 6u);
  EXPECT_EQ(set.nodes.dof_block[0], -1);
  EXPECT_EQ(set.nodes.dof_block[8], 0);
  double mass = 0;
  for (const Element& element : set.elements) mass += element.mass;
  EXPECT_NEAR(mass, 2600 * 3, 1e-9);
}

}  // namespace
}  // namespace talus
