#include "study/forecast.hpp"

#include <gmock/gmock.h>

#include "support/solver_scenes.hpp"

namespace talus {
namespace {

double length_of(const Stage& stage) { return stage.steps ? *stage.steps * stage.time_step : *stage.duration; }

double length_of(const Project& project) {
  double sum = 0;
  for (const Stage& stage : project.stages) sum += length_of(stage);
  return sum;
}

Project sliding(int steps) {
  Project project = test::rock_project(
      20, {{"settle", StageKind::static_, 0.01, 10, {}}, {"slide", StageKind::dynamic, 0.001, steps, {}}});
  project.gravity = test::tilted_gravity(30);
  return project;
}

TEST(Forecast, APilotGoesThroughTheSameModelTimeInFewerSteps) {
  Project project = sliding(10000);
  project.stages[1].joints = {{"J", 15.0, {}, {}, {}}};
  const Project pilot = pilot_of(project);
  EXPECT_NEAR(length_of(pilot), length_of(project), 1e-9);
  EXPECT_EQ(pilot.stages[0], project.stages[0]);
  int steps = 0, changed = 0;
  for (const Stage& stage : pilot.stages) {
    steps += *stage.steps;
    changed += stage.joints.empty() ? 0 : 1;
  }
  EXPECT_LT(steps, 1000);
  EXPECT_EQ(changed, 1) << "what a stage changes, it changes once";
}

TEST(Forecast, APilotDoesNotWaitUntilALongStaticStageIsOver) {
  Project project = sliding(200);
  project.stages[0].steps = 4000;
  const Project pilot = pilot_of(project);
  EXPECT_NEAR(length_of(pilot), length_of(project), 1e-9);
  int steps = 0;
  for (const Stage& stage : pilot.stages) steps += *stage.steps;
  EXPECT_LT(steps, 400);
  project.stages[0].until_equilibrium = true;
  EXPECT_EQ(pilot_of(project), project) << "when it ends nobody knows before";
}

TEST(Forecast, ShortAndAdaptiveStagesAreGoneThroughAsTheyAre) {
  EXPECT_EQ(pilot_of(sliding(200)), sliding(200));
  Project adaptive = sliding(10000);
  adaptive.solver.time_step_control = TimeStepControl::adaptive;
  EXPECT_EQ(pilot_of(adaptive), adaptive);
}

TEST(Forecast, SaysWhatASlideWillCostAndLeaveOut) {
  NoProgress progress;
  const Project project = sliding(1000);
  const Forecast found = forecast(project, test::cube_on_slab(), 1e3, progress);
  EXPECT_EQ(found.steps, 1010);
  EXPECT_EQ(found.share_seen, 1);
  EXPECT_GT(found.seconds, 0);
  ASSERT_TRUE(found.error);
  EXPECT_LT(*found.error, 1e-4) << "constant acceleration is exact but for the first step's elastic rebound";
}

TEST(Forecast, EndsWithItsBudgetAndSaysHowMuchItSaw) {
  NoProgress progress;
  const Forecast found = forecast(sliding(10000), test::cube_on_slab(), 1e-9, progress);
  EXPECT_LT(found.share_seen, 0.1);
  EXPECT_FALSE(found.error);
}

TEST(Forecast, CanBeCancelled) {
  struct Cancelling final : Progress {
    bool cancelled() const override { return true; }
    void report(double, std::string_view) override {}
  } progress;
  EXPECT_THROW(forecast(sliding(1000), test::cube_on_slab(), 1, progress), Cancelled);
}

}  // namespace
}  // namespace talus
