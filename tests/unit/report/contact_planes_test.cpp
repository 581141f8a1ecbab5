#include "report/contact_planes.hpp"

#include <gmock/gmock.h>

#include "support/small_scenes.hpp"

namespace talus::report {
namespace {

TEST(ContactPlanes, LieWhereBlocksTouchAndHaveTheJointThatTheProjectGivesThem) {
  BlockSystem system;
  system.blocks = {test::box_block("base", Vec3(0, 0, 0), Vec3(4, 4, 1), BodyKind::fixed),
                   test::box_block("left", Vec3(0, 0, 1), Vec3(2, 4, 2)),
                   test::box_block("right", Vec3(2, 0, 1), Vec3(4, 4, 3))};
  Project project;
  project.default_joint = "bedding";
  project.interfaces = {{.between = {"right", "left"}, .joint = "fault"}};
  const std::vector<ContactPlane> planes = contact_planes(system, project);
  ASSERT_EQ(planes.size(), 3u);
  EXPECT_EQ(planes[0].joint, "bedding");
  EXPECT_NEAR(planes[0].area, 8, 1e-12);
  EXPECT_NEAR(planes[0].attitude.dip, 0, 1e-9);
  EXPECT_EQ(planes[2].joint, "fault");
  EXPECT_NEAR(planes[2].area, 4, 1e-12);
  EXPECT_NEAR(planes[2].attitude.dip, 90, 1e-9);
  system.blocks[1].body = BodyKind::fixed;
  EXPECT_EQ(contact_planes(system, project).size(), 2u);
}

}  // namespace
}  // namespace talus::report
