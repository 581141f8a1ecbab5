#include "model/stage_changes.hpp"

#include <gtest/gtest.h>

namespace talus {
namespace {

/// Three stages: nothing changes, then much, then a little.
Project staged() {
  Project project;
  Joint joint;
  joint.name = "J1";
  joint.friction_angle = 30;
  joint.cohesion = 1e5;
  project.joints = {joint, joint};
  project.joints[1].name = "J2";
  project.loads = {{"B", {0, 0, 0}, {1, 0, 0}}};
  project.constraints = {{"B", Vec3(0, 0, 0)}};
  project.stages.resize(3);
  project.stages[1].joints = {{"J1", 20, {}, {}, {}}};
  project.stages[1].loads.emplace();
  project.stages[1].blocks = {{"B", BodyKind::fixed}, {"C", BodyKind::fixed}};
  project.stages[2].joints = {{"J1", {}, 15, 0, {}}};
  project.stages[2].constraints = {{"C", Vec3(1, 1, 1)}};
  project.stages[2].blocks = {{"B", BodyKind::tetrahedra}};
  return project;
}

TEST(StageChanges, WhatIsAbsentStaysAsItWas) {
  const Project project = staged();
  EXPECT_EQ(project_in_stage(project, 0), project);
  const Project last = project_in_stage(project, 2);
  EXPECT_EQ(last.joints[0].friction_angle, 20);
  EXPECT_EQ(last.joints[0].residual_friction_angle, 15);
  EXPECT_EQ(last.joints[0].cohesion, 0);
  EXPECT_EQ(last.joints[1], project.joints[1]);
}

TEST(StageChanges, ListsTakeThePlaceOfThoseBefore) {
  const Project project = staged();
  EXPECT_TRUE(project_in_stage(project, 1).loads.empty());
  EXPECT_EQ(project_in_stage(project, 1).constraints, project.constraints);
  EXPECT_TRUE(project_in_stage(project, 2).loads.empty());
  EXPECT_EQ(project_in_stage(project, 2).constraints, *project.stages[2].constraints);
}

TEST(StageChanges, ABlockIsHeldUntilItIsLetGo) {
  const Project project = staged();
  EXPECT_TRUE(blocks_held_in_stage(project, 0).empty());
  EXPECT_EQ(blocks_held_in_stage(project, 1), (std::vector<std::string>{"B", "C"}));
  EXPECT_EQ(blocks_held_in_stage(project, 2), std::vector<std::string>{"C"});
}

}  // namespace
}  // namespace talus
