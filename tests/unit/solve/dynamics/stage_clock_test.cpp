#include "solve/dynamics/stage_clock.hpp"

#include <gmock/gmock.h>

namespace talus {
namespace {

Stage stage(double step, std::optional<int> steps, std::optional<double> duration) {
  return {"s", StageKind::dynamic, step, steps, duration};
}

TEST(StageClock, ThousandStepsOfAHundredthEndAtTenExactly) {
  StageClock clock({stage(0.01, 1000, {})});
  for (int i = 0; i < 1000; ++i) {
    EXPECT_FALSE(clock.finished());
    clock.advance();
  }
  EXPECT_TRUE(clock.finished());
  EXPECT_EQ(clock.time(), 10.0);
}

TEST(StageClock, DurationThatIsNoMultipleEndsWithAShorterStep) {
  StageClock clock({stage(0.3, {}, 1.0)});
  EXPECT_EQ(clock.total_steps(), 4);
  for (int i = 0; i < 3; ++i) clock.advance();
  EXPECT_NEAR(clock.next_length(), 0.1, 1e-15);
  clock.advance();
  EXPECT_TRUE(clock.finished());
  EXPECT_EQ(clock.time(), 1.0);
}

TEST(StageClock, DurationOfManyStepsIsNotLengthenedByRoundOff) {
  EXPECT_EQ(StageClock({stage(0.1, {}, 0.3)}).total_steps(), 3);
  EXPECT_EQ(StageClock({stage(0.01, {}, 60)}).total_steps(), 6000);
}

TEST(StageClock, TellsWhereStagesBeginAndEnd) {
  StageClock clock({stage(0.5, 2, {}), stage(0.25, 1, {})});
  EXPECT_TRUE(clock.stage_begins());
  EXPECT_FALSE(clock.stage_ended());
  clock.advance();
  EXPECT_FALSE(clock.stage_begins());
  clock.advance();
  EXPECT_TRUE(clock.stage_ended());
  EXPECT_EQ(clock.stage(), 1);
  EXPECT_EQ(clock.next_length(), 0.25);
}

}  // namespace
}  // namespace talus
