#include <gmock/gmock.h>

#include <algorithm>

#include "stability/all_scenes.hpp"
#include "stability/trial.hpp"

// Compiled twice: for the scenes that are quick, and (TALUS_LONG_SCENES) for the others.
namespace talus {
namespace {

std::vector<StabilityScene> scenes_of_this_program() {
  std::vector<StabilityScene> scenes = stability_scenes();
  std::erase_if(scenes, [](const StabilityScene& scene) { return scene.takes_long != TALUS_LONG_SCENES; });
  return scenes;
}

class StabilityOf : public testing::TestWithParam<StabilityScene> {};

/// Quick ones once more on one thread and on two, which must give the same bits. Those that are known to fall short are
/// run as well, and must go on falling short, finite and the same every time.
TEST_P(StabilityOf, IsHeld) {
  NoProgress progress;
  const Trial trial = run_trial(GetParam(), {1, !TALUS_LONG_SCENES}, progress);
  if (GetParam().shortfall.empty()) {
    EXPECT_THAT(faults(trial), testing::IsEmpty());
    return;
  }
  EXPECT_THAT(faults(trial), testing::Not(testing::IsEmpty())) << "holds now: take its shortfall off";
  EXPECT_TRUE(trial.finite);
  EXPECT_NE(trial.ending, TrialEnding::broken_off) << trial.reason;
  EXPECT_GT(trial.least_volume, 0);
  for (const TrialRepetition& repetition : trial.repetitions) EXPECT_EQ(repetition.difference, "");
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(StabilityOf);
INSTANTIATE_TEST_SUITE_P(, StabilityOf, testing::ValuesIn(scenes_of_this_program()),
                         [](const testing::TestParamInfo<StabilityScene>& one) { return one.param.name; });

}  // namespace

/// For messages of GoogleTest.
void PrintTo(const StabilityScene& scene, std::ostream* stream) { *stream << scene.name; }

}  // namespace talus
