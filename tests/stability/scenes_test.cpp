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

/// Quick ones once more on one thread and on two, which must give the same bits.
TEST_P(StabilityOf, IsHeld) {
  NoProgress progress;
  EXPECT_THAT(faults(run_trial(GetParam(), {1, !TALUS_LONG_SCENES}, progress)), testing::IsEmpty());
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(StabilityOf);
INSTANTIATE_TEST_SUITE_P(, StabilityOf, testing::ValuesIn(scenes_of_this_program()),
                         [](const testing::TestParamInfo<StabilityScene>& one) { return one.param.name; });

}  // namespace

/// For messages of GoogleTest.
void PrintTo(const StabilityScene& scene, std::ostream* stream) { *stream << scene.name; }

}  // namespace talus
