#include "model/rules/switched_effects.hpp"

#include <gmock/gmock.h>

namespace talus {
namespace {

using Kind = ProjectProblem::Kind;
using testing::ElementsAre;
using testing::IsEmpty;

Project moving_blocks() {
  Project project;
  project.joints = {{"J", 30, 0, 0, {}, {}, {}, {}}};
  project.stages.resize(1);
  project.stages[0].kind = StageKind::dynamic;
  return project;
}

std::vector<std::string> places_told_of(const Project& project, Kind kind) {
  std::vector<std::string> found;
  for (const ProjectProblem& problem : problems_of_switched_effects(project))
    if (problem.kind == kind) found.push_back(problem.place);
  return found;
}

TEST(SwitchedEffects, AProjectThatSwitchesNothingIsToldOfNothing) {
  Project project = moving_blocks();
  project.joints[0].restitution = 0.4;
  EXPECT_THAT(problems_of_switched_effects(project), IsEmpty());
}

TEST(SwitchedEffects, ImpactsOffWithARestitutionGivenAreWarnedOf) {
  Project project = moving_blocks();
  project.joints[0].restitution = 0.4;
  project.solver.effects.rebound = Switch::off;
  EXPECT_THAT(places_told_of(project, Kind::warning), ElementsAre("/solver/effects/rebound"));
  EXPECT_THAT(problems_of_switched_effects(project)[0].problem, testing::HasSubstr("restitution of J"));
  project.solver.effects.rebound = Switch::called_for;
  project.solver.effects.restitution = Switch::off;
  EXPECT_THAT(places_told_of(project, Kind::warning), ElementsAre("/solver/effects/restitution"));
}

TEST(SwitchedEffects, SettingsThatAskForNothingBeyondTheEquationsLoseARestitutionUnlessItIsSwitchedOn) {
  Project project = moving_blocks();
  project.joints[0].restitution = 0.4;
  project.solver.extras = Extras::none;
  EXPECT_THAT(places_told_of(project, Kind::warning), ElementsAre("/solver/effects/rebound"));
  project.solver.effects.restitution = Switch::on;
  EXPECT_THAT(problems_of_switched_effects(project), IsEmpty());
}

TEST(SwitchedEffects, APenetrationThatIsNotHeldIsToldWithItsFigure) {
  Project project = moving_blocks();
  project.solver.penetration_tolerance = 1e-5;
  project.solver.effects.penalty_scaling = Switch::off;
  const auto problems = problems_of_switched_effects(project);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].kind, Kind::warning);
  EXPECT_EQ(problems[0].problem, "the penetration_tolerance of 1e-5 is not held in dynamic stages");
}

TEST(SwitchedEffects, WhatOnlyCostsIsAHintAndWhatChangesTheAnswerAWarning) {
  Project project = moving_blocks();
  for_each_switch(project.solver.effects, [](const char*, Switch& choice) { choice = Switch::off; });
  EXPECT_THAT(places_told_of(project, Kind::warning),
              testing::UnorderedElementsAre("/solver/effects/contact", "/solver/effects/rebound",
                                            "/solver/effects/penalty_scaling", "/solver/effects/updated_normals",
                                            "/solver/effects/missed_contacts", "/solver/effects/acceleration_reset"));
  EXPECT_THAT(places_told_of(project, Kind::hint),
              testing::UnorderedElementsAre("/solver/effects/sleep", "/solver/effects/followed_springs",
                                            "/solver/effects/elimination"));
}

TEST(SwitchedEffects, StaticStagesHaveNoneOfWhatDynamicOnesHave) {
  Project project = moving_blocks();
  project.stages[0].kind = StageKind::static_;
  for_each_switch(project.solver.effects, [](const char*, Switch& choice) { choice = Switch::off; });
  EXPECT_THAT(places_told_of(project, Kind::warning), ElementsAre("/solver/effects/contact"));
  EXPECT_THAT(places_told_of(project, Kind::hint), ElementsAre("/solver/effects/elimination"));
}

TEST(SwitchedEffects, SleepThatNothingCanDoIsWarnedOf) {
  Project project = moving_blocks();
  project.solver.effects.sleep = Switch::on;
  EXPECT_THAT(problems_of_switched_effects(project), IsEmpty());
  project.solver.sleep_tolerance = 0;
  EXPECT_THAT(places_told_of(project, Kind::warning), ElementsAre("/solver/effects/sleep"));
}

}  // namespace
}  // namespace talus
