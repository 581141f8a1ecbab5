#include <gmock/gmock.h>

#include <algorithm>

#include "support/written_tables.hpp"
#include "verification/hard_cases/scenes/all_hard_cases.hpp"
#include "verification/hard_cases/trial.hpp"
#include "verification/hard_cases_page.hpp"

namespace talus {
namespace {

std::vector<HardCase> scenes(bool take_long) {
  std::vector<HardCase> chosen = hard_cases();
  std::erase_if(chosen, [=](const HardCase& scene) { return scene.takes_long != take_long; });
  return chosen;
}

const std::string stale = test::how_to_mend("--hard-cases", "hard_cases.md");

const test::WrittenPage& written() {
  static const test::WrittenPage page("hard_cases.md");
  return page;
}

TEST(HardCasesTable, HasEveryQuickSceneInItsGroup) {
  const std::vector<HardCase> quick = scenes(false);
  std::vector<std::string> names;
  std::string group;
  for (const HardCase& scene : quick) {
    if (scene.group != group) names.push_back("### " + (group = scene.group));
    names.push_back(scene.name);
  }
  if (std::ranges::any_of(quick, [](const HardCase& scene) { return !scene.shortfall.empty(); }))
    names.push_back("### What does not hold");
  EXPECT_EQ(written().names(), names) << stale;
}

class HardCaseOf : public testing::TestWithParam<HardCase> {};

/// Quick ones once more, on two threads and taken up anew 25 times, which must give the same bits, and the figures of
/// their table. Those that are known to fall short are run as well, and must go on falling short, finite and the same
/// every time.
TEST_P(HardCaseOf, IsHeld) {
  NoProgress progress;
  TrialOptions options{.threads = 1};
  const bool quick = !GetParam().takes_long;
  if (quick) options.repeat_on = {2};
  const Trial trial = run_trial(GetParam(), options, progress);
  if (quick && test::has_arithmetic_of_tables()) {
    EXPECT_EQ(test::difference(written().row(trial.name), trial_row(trial)), "") << stale;
  }
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

std::string test_name(const testing::TestParamInfo<HardCase>& one) { return one.param.name; }

INSTANTIATE_TEST_SUITE_P(, HardCaseOf, testing::ValuesIn(scenes(false)), test_name);
INSTANTIATE_TEST_SUITE_P(Long, HardCaseOf, testing::ValuesIn(scenes(true)), test_name);

}  // namespace

/// For messages of GoogleTest.
void PrintTo(const HardCase& scene, std::ostream* stream) { *stream << scene.name; }

}  // namespace talus
