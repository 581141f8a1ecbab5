#include "study/forecast/forecast.hpp"

#include <gmock/gmock.h>

#include "model/stage_length.hpp"
#include "study/forecast/run_beginning.hpp"
#include "study/forecast/run_outline.hpp"
#include "support/solver_scenes.hpp"

namespace talus {
namespace {

Project sliding(int steps) {
  Project project = test::rock_project(
      20, {{"static", StageKind::static_, 0.01, 10, {}}, {"slide", StageKind::dynamic, 0.001, steps, {}}});
  project.gravity = test::tilted_gravity(30);
  return project;
}

double length_of(const Project& project) {
  double sum = 0;
  for (const Stage& stage : project.stages) sum += length_of(stage);
  return sum;
}

struct Cancelling final : Progress {
  bool cancelled() const override { return true; }
  void report(double, std::string_view) override {}
};

TEST(RunBeginning, IsTheRunItselfButForLongStaticStages) {
  Project project = sliding(200);
  EXPECT_EQ(beginning_of(project, 100), project);
  project.stages[0].steps = 4000;
  project.stages[0].joints = {{"J", 15.0, {}, {}, {}}};
  const Project beginning = beginning_of(project, 100);
  ASSERT_EQ(beginning.stages.size(), 3u);
  EXPECT_NEAR(length_of(beginning), length_of(project), 1e-9);
  EXPECT_EQ(beginning.stages[0].time_step, project.stages[0].time_step);
  EXPECT_LT(*beginning.stages[0].steps + *beginning.stages[1].steps, 150);
  EXPECT_TRUE(beginning.stages[1].joints.empty()) << "what a stage changes, it changes once";
  EXPECT_EQ(beginning.stages[2], project.stages[1]);
  project.stages[0].until_equilibrium = true;
  EXPECT_EQ(beginning_of(project, 100), project) << "when it ends nobody knows before";
}

TEST(RunBeginning, HasEveryStepOfARunThatItsBudgetLasts) {
  NoProgress progress;
  const RunBeginning seen = run_beginning(sliding(100), test::cube_on_slab(), 1e3, progress);
  EXPECT_TRUE(seen.whole);
  ASSERT_EQ(seen.stages.size(), 2u);
  EXPECT_EQ(seen.stages[0].steps.size(), 10u);
  EXPECT_EQ(seen.stages[1].steps.size(), 100u);
  EXPECT_TRUE(seen.stages[0].ended);
  EXPECT_TRUE(seen.stages[1].ended);
  EXPECT_GT(seen.around, 0);
  EXPECT_GT(seen.memory, 0);
  for (const TimedStep& step : seen.stages[1].steps) {
    EXPECT_NEAR(step.length, 0.001, 1e-12);
    EXPECT_GT(step.seconds, 0);
    EXPECT_THAT(step.detecting, testing::AllOf(testing::Ge(0), testing::Le(1)));
    EXPECT_THAT(step.iterating, testing::AllOf(testing::Ge(0), testing::Le(1 - step.detecting)));
  }
}

TEST(RunBeginning, EndsWithItsBudget) {
  NoProgress progress;
  const RunBeginning seen = run_beginning(sliding(100), test::cube_on_slab(), 1e-9, progress);
  EXPECT_FALSE(seen.whole);
  ASSERT_EQ(seen.stages.size(), 1u);
  EXPECT_EQ(seen.stages[0].steps.size(), 2u) << "the first step is unlike all others";
  EXPECT_FALSE(seen.stages[0].ended);
}

/// A cube over a slab that it does not reach before the run's middle, and then stays on.
TEST(RunOutline, TellsWhenThereAreContacts) {
  Project project = test::rock_project(20, {{"fall", StageKind::dynamic, 0.001, 1000, {}}});
  project.joints[0].restitution = 0;
  const BlockSystem system =
      test::block_system({test::box_block("ground", Vec3(-5, -5, -1), Vec3(5, 5, 0), BodyKind::fixed),
                          test::box_block("B", Vec3(0, 0, 1.3), Vec3(1, 1, 2.3))});  // 0.515 s above it
  NoProgress progress;
  const RunOutline outline(project, system, 1, 1e3, progress);
  ASSERT_TRUE(outline.came_through());
  EXPECT_EQ(outline.load(0, 0, 0.4)->contacts, 0);
  EXPECT_GE(outline.load(0, 0.55, 1)->contacts, 1);
  EXPECT_EQ(outline.load(0, 0, 0.5)->awake, 1);
  EXPECT_FALSE(outline.load(1, 0, 1));
  EXPECT_NEAR(outline.displacements()[1].z(), -1.3, 0.05);
}

/// Of a run that takes minutes the budget would see the first steps alone.
TEST(RunBeginning, SeesATenthOfALongRunOrSpendsFiveTimesItsBudget) {
  NoProgress progress;
  const double budget = 0.01;
  const RunBeginning seen = run_beginning(sliding(20000), test::cube_on_slab(), budget, progress);
  double steps = 0, seconds = 0;
  for (const StageBeginning& stage : seen.stages)
    for (const TimedStep& step : stage.steps) {
      ++steps;
      seconds += step.seconds;
    }
  EXPECT_FALSE(seen.whole);
  EXPECT_TRUE(steps >= 2000 || seconds >= 5 * budget) << steps << " steps, " << seconds << " s";
  EXPECT_GE(seen.seconds, seconds);
}

TEST(RunBeginning, OfARunWithoutAnEndInSightSpendsNoMoreThanItsBudget) {
  NoProgress progress;
  const double budget = 0.05;
  const RunBeginning seen = run_beginning(sliding(20000000), test::cube_on_slab(), budget, progress);
  double seconds = 0;
  for (const StageBeginning& stage : seen.stages)
    for (const TimedStep& step : stage.steps) seconds += step.seconds;
  EXPECT_GE(seconds, budget);
  EXPECT_LT(seconds, 2 * budget);
}

/// It slides without an iteration once its contacts are known.
TEST(RunOutline, TellsHowManyIterationsStepsTake) {
  NoProgress progress;
  const RunOutline outline(sliding(1000), test::cube_on_slab(), 1, 1e3, progress);
  ASSERT_TRUE(outline.came_through());
  EXPECT_GE(outline.load(0, 0, 0.01)->iterations, 1) << "the first step finds out what bears";
  EXPECT_LT(outline.load(1, 0.5, 1)->iterations, 1);
  EXPECT_EQ(outline.last()->iterations, outline.load(1, 0.9, 1)->iterations);
}

TEST(RunOutline, TellsWhenBlocksSleep) {
  Project project = test::rock_project(40, {{"rest", StageKind::dynamic, 0.01, 1000, {}}});
  NoProgress progress;
  const RunOutline outline(project, test::cube_on_slab(), 1, 1e3, progress);
  EXPECT_EQ(outline.load(0, 0, 0.1)->awake, 1);
  EXPECT_EQ(outline.load(0, 9, 10)->awake, 0);
}

TEST(Forecast, MeasuresARunThatIsShortAndSaysWhatItsStepsLeaveOut) {
  NoProgress progress;
  const Forecast found = forecast(sliding(1000), test::cube_on_slab(), 1e3, progress);
  EXPECT_EQ(found.steps, 1010);
  EXPECT_EQ(found.share_seen, 1);
  EXPECT_GT(found.seconds, 0);
  EXPECT_LT(found.seconds, found.forecast_seconds);
  ASSERT_TRUE(found.error);
  EXPECT_LT(*found.error, 1e-4) << "constant acceleration is exact but for the first step's rebound";
}

TEST(Forecast, ForeseesWhatItsBudgetDoesNotLastForAndSaysARange) {
  NoProgress progress;
  const Forecast found = forecast(sliding(100000), test::cube_on_slab(), 0.05, progress);
  EXPECT_LT(found.share_seen, 0.2);
  EXPECT_LT(found.fewest, found.seconds / 1.2);
  EXPECT_GT(found.most, found.seconds * 1.2);
  EXPECT_LT(found.forecast_seconds, found.seconds);
}

/// A block of many tetrahedra settles in the first steps and slides on without iterations: of these alone many times
/// what it takes would be foreseen.
TEST(Forecast, TakesFirstStepsForWhatTheyAre) {
  NoProgress progress;
  Project project = test::rock_project(20, {{"slide", StageKind::dynamic, 0.001, 400, {}}});
  project.gravity = test::tilted_gravity(30);
  const Forecast few = forecast(project, test::cube_on_slab(), 1e-6, progress);
  const Forecast whole = forecast(project, test::cube_on_slab(), 1e3, progress);
  EXPECT_LT(few.fewest, whole.seconds);
  EXPECT_GT(few.most, whole.seconds);
}

TEST(Forecast, SaysThatARunWillNotConverge) {
  NoProgress progress;
  Project project = sliding(100);
  project.solver.open_close_limit = 1;
  EXPECT_THAT(forecast(project, test::cube_on_slab(), 1e3, progress).failure, testing::HasSubstr("did not converge"));
  EXPECT_EQ(forecast(sliding(100), test::cube_on_slab(), 1e3, progress).failure, "");
}

TEST(Forecast, HasNoErrorWhereTheStepsChooseTheirLength) {
  NoProgress progress;
  Project adaptive = sliding(100);
  adaptive.solver.time_step_control = TimeStepControl::adaptive;
  EXPECT_FALSE(forecast(adaptive, test::cube_on_slab(), 1e3, progress).error);
}

TEST(Forecast, CanBeCancelled) {
  Cancelling progress;
  EXPECT_THROW(forecast(sliding(1000), test::cube_on_slab(), 1, progress), Cancelled);
}

}  // namespace
}  // namespace talus
