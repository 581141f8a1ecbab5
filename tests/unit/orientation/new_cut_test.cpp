#include "orientation/new_cut.hpp"

#include <gtest/gtest.h>

namespace talus {
namespace {

Project with_joint(const std::string& name) {
  Project project;
  project.joints.emplace_back().name = name;
  return project;
}

TEST(NewCut, IsOfTheJointThatIsWanted) {
  Project project = with_joint("A");
  project.joints.emplace_back().name = "B";
  EXPECT_EQ(with_cut(project, {45, 90}, Vec3::Zero(), "B").cuts.back().joint, "B");
  EXPECT_EQ(with_cut(project, {45, 90}, Vec3::Zero(), "").cuts.back().joint, "A");
  project.default_joint = "B";
  EXPECT_EQ(with_cut(project, {45, 90}, Vec3::Zero(), "").cuts.back().joint, "B");
}

TEST(NewCut, InAProjectWithoutJointsBringsOne) {
  const Project project = with_cut({}, {45, 90}, Vec3::Zero(), "");
  ASSERT_EQ(project.joints.size(), 1u);
  EXPECT_EQ(project.cuts.back().joint, project.joints[0].name);
  EXPECT_GT(project.joints[0].friction_angle, 0);
}

TEST(NewCut, HasNumbersThatCanBeRead) {
  const Cut cut = with_cut(with_joint("A"), {44.99999997, 359.9999}, {1.00000004, 2, 3}, "").cuts.back();
  EXPECT_EQ(cut.dip, 45);
  EXPECT_EQ(cut.dip_direction, 0);
  EXPECT_EQ(cut.through, Vec3(1, 2, 3));
}

TEST(NewInterface, ReplacesTheOneBefore) {
  Project project = with_interface({}, "one", "two", "A");
  project = with_interface(project, "two", "one", "B");
  ASSERT_EQ(project.interfaces.size(), 1u);
  EXPECT_EQ(project.interfaces[0].joint, "B");
  EXPECT_EQ(with_interface(project, "one", "three", "A").interfaces.size(), 2u);
}

}  // namespace
}  // namespace talus
