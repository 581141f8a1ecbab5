#include "verification/smaller_scene.hpp"

#include <gmock/gmock.h>

#include "model/stages.hpp"
#include "verification/hard_cases/shapes.hpp"

namespace talus {
namespace {

/// Two cubes that begin in each other, and two that fly by themselves.
CaseScene overlapping() {
  CaseScene scene = rock_scene(30);
  scene.project.gravity.setZero();
  scene.add_block("in one", cube(1), BodyKind::rigid);
  scene.add_block("far", placed(cube(1), {20, 0, 0}), BodyKind::rigid);
  scene.add_block("another", placed(cube(1), {0.3, 0.2, 0.1}), BodyKind::rigid);
  scene.add_block("farther", placed(cube(1), {40, 0, 0}), BodyKind::rigid);
  scene.project.velocities = {{.block = "far", .linear = {1, 0, 0}}};
  scene.project.stages = {dynamic_stage(1e-3, 0.02), dynamic_stage(1e-3, 0.01)};
  return scene;
}

CaseScene smaller(int most_runs) {
  NoProgress progress;
  return smaller_scene(overlapping(), FaultKind::interpenetration, most_runs, {}, progress);
}

TEST(SmallerScene, HasOneStepAndTheTwoBlocksThatFail) {
  const CaseScene scene = smaller(100);
  ASSERT_EQ(scene.project.stages.size(), 1U);
  EXPECT_NEAR(*scene.project.stages[0].duration, 1e-3, 1e-12);
  ASSERT_EQ(scene.system.blocks.size(), 2U);
  EXPECT_EQ(scene.system.blocks[0].name, "in one");
  EXPECT_EQ(scene.system.blocks[1].name, "another");
  EXPECT_TRUE(scene.project.velocities.empty()) << "of blocks that are not there";
}

TEST(SmallerScene, EndsAfterSoManyRuns) {
  EXPECT_EQ(smaller(1).project.stages.size(), 1U);
  EXPECT_EQ(smaller(1).system.blocks.size(), 4U);
  EXPECT_EQ(smaller(0).project.stages.size(), 2U);
}

TEST(SmallerScene, StaysAsItIsWhereNothingSmallerFails) {
  NoProgress progress;
  const CaseScene scene = smaller_scene(overlapping(), FaultKind::inverted, 100, {}, progress);
  EXPECT_EQ(scene.project, overlapping().project);
  EXPECT_EQ(scene.system.blocks.size(), 4U);
}

TEST(SmallerScene, IsLookedForWhereALawIsBroken) {
  Trial trial;
  trial.unmet = {{FaultKind::expectation, "it rests"}};
  EXPECT_EQ(law_broken(trial), std::nullopt);
  trial.grows = true;
  trial.penetration = 1;
  EXPECT_EQ(law_broken(trial), FaultKind::energy);
  trial.ending = TrialEnding::not_converged;
  EXPECT_EQ(law_broken(trial), FaultKind::not_converged);
}

}  // namespace
}  // namespace talus
