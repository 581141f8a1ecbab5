#include "orientation/project_joints.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace talus {
namespace {

Joint joint_of(const std::string& name, double friction_angle) {
  Joint joint;
  joint.name = name;
  joint.friction_angle = friction_angle;
  return joint;
}

TEST(ProjectJoints, AreTheCutsWithTheirSets) {
  Project project;
  project.cuts.push_back({"J1", 45, 120, Vec3(1, 2, 3), 2, 5, {}});
  const std::vector<MeasuredJoint> joints = joints_of(project).joints;
  ASSERT_EQ(joints.size(), 1u);
  EXPECT_EQ(joints[0], (MeasuredJoint{{45, 120}, "J1", Vec3(1, 2, 3), 2}));
}

TEST(ProjectJoints, OfACutThatIsDrawnAreAllItsPlanes) {
  Project project;
  project.cuts.push_back({"J1", 45, 120, Vec3(1, 2, 3), 2, 5, {}});
  project.cuts.push_back(project.cuts[0]);
  project.cuts[1].fisher_kappa = 100;
  const ProjectJoints found = joints_of(project);
  EXPECT_THAT(found.cuts, testing::ElementsAre(0, 1, 1, 1, 1, 1));
  EXPECT_NE(found.joints[1].plane, found.joints[2].plane);
  EXPECT_TRUE(found.complete);
  const ProjectJoints fewer = joints_of(project, 2);
  EXPECT_FALSE(fewer.complete);
  EXPECT_THAT(fewer.cuts, testing::ElementsAre(0, 1, 1));
  EXPECT_EQ(fewer.joints[2], found.joints[2]) << "the first ones are the same";
}

TEST(ProjectJoints, OfANetworkAreAllItsDiscs) {
  Project project;
  Cut cut;
  cut.joint = "J1";
  cut.network = JointNetwork{{{0, 0, 0}, {10, 10, 10}}, 1, 1, RadiusLaw::equal, {}};
  project.cuts = {cut};
  EXPECT_EQ(joints_of(project).joints.size(), 319u);  // 1000 m² over π
  EXPECT_EQ(joints_of(project, 20).joints.size(), 20u);
  EXPECT_FALSE(joints_of(project, 20).complete);
}

TEST(ProjectJoints, AreAddedWithTheJointsThatTheyName) {
  Project project;
  project.joints.push_back(joint_of("J1", 25));
  const std::vector<MeasuredJoint> measured{{{45, 120}, "J1", Vec3(1, 2, 3)}, {{60, 30}, "K"}, {{5, 0}, ""}};
  const Project changed = with_joints(project, measured, joint_of("joint", 33), Vec3(7, 8, 9));
  ASSERT_EQ(changed.joints.size(), 3u);
  EXPECT_EQ(changed.joints[0].friction_angle, 25);
  EXPECT_EQ(changed.joints[1], joint_of("K", 33));
  EXPECT_EQ(changed.joints[2].name, "joint");
  ASSERT_EQ(changed.cuts.size(), 3u);
  EXPECT_EQ(changed.cuts[0].through, Vec3(1, 2, 3));
  EXPECT_EQ(changed.cuts[1].through, Vec3(7, 8, 9));
  EXPECT_EQ(changed.cuts[1].joint, "K");
  EXPECT_EQ(changed.cuts[1].dip, 60);
  EXPECT_EQ(changed.default_joint, "J1") << "contacts on no cut need one";
  project.default_joint = "K";
  EXPECT_EQ(with_joints(project, measured, joint_of("joint", 33), Vec3::Zero()).default_joint, "K");
}

TEST(ProjectJoints, WithASpacingGoThroughAllOfTheRock) {
  const BoxShape rock{{0, 0, 0}, {10, 10, 10}};
  MeasuredJoint flat{{0, 0}, "B", Vec3(5, 5, 4.5)};
  flat.spacing = 2;
  MeasuredJoint steep{{45, 90}, "J"};
  steep.spacing = 3;
  MeasuredJoint wide{{0, 0}, "W", Vec3(5, 5, 4.5)};
  wide.spacing = 12;
  const std::vector<MeasuredJoint> measured{flat, steep, wide, {{60, 30}, "K"}};
  const Project changed = with_joints({}, measured, joint_of("joint", 33), Vec3(5, 5, 5), rock);
  ASSERT_EQ(changed.cuts.size(), 4u);
  EXPECT_EQ(changed.cuts[0].spacing, 2);
  EXPECT_EQ(changed.cuts[0].count, 5) << "at 0.5, 2.5 … 8.5 m";
  EXPECT_EQ(changed.cuts[0].through, Vec3(5, 5, 0.5));
  // The box reaches 5 √2 = 7.07 m to both sides of its middle.
  EXPECT_EQ(changed.cuts[1].count, 5);
  EXPECT_LT((changed.cuts[1].through - Vec3(5 - 6 * std::sqrt(0.5), 5, 5 - 6 * std::sqrt(0.5))).norm(), 2e-6);
  EXPECT_FALSE(changed.cuts[2].count) << "one plane of them meets the rock";
  EXPECT_EQ(changed.cuts[2].through, Vec3(5, 5, 4.5));
  EXPECT_FALSE(changed.cuts[3].spacing);
  EXPECT_FALSE(with_joints({}, measured, joint_of("joint", 33), Vec3(5, 5, 5)).cuts[0].spacing);
}

}  // namespace
}  // namespace talus
