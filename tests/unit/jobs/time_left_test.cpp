#include "jobs/time_left.hpp"

#include <gtest/gtest.h>

namespace talus {
namespace {

TEST(TimeLeft, IsSilentUntilThereIsEnoughToGoBy) {
  TimeLeft left;
  EXPECT_FALSE(left.seconds());
  left.update(0.1, 0.01);
  left.update(0.2, 0.02);
  EXPECT_FALSE(left.seconds());
}

TEST(TimeLeft, ASteadyRunEndsWhenItsPaceSays) {
  TimeLeft left;
  for (int i = 1; i <= 40; ++i) left.update(i, i / 100.0);
  EXPECT_NEAR(*left.seconds(), 60, 1e-9);
}

TEST(TimeLeft, FollowsARunThatBecomesSlower) {
  TimeLeft left;
  for (int i = 1; i <= 30; ++i) left.update(i, i / 100.0);              // 1 % a second
  for (int i = 1; i <= 30; ++i) left.update(30 + i, 0.3 + i / 1000.0);  // then 0.1 % a second
  EXPECT_NEAR(*left.seconds(), 670, 1e-6);                              // the mean would say 49 s
}

TEST(TimeLeft, AStandstillHasNoEnd) {
  TimeLeft left;
  for (int i = 1; i <= 30; ++i) left.update(i, i / 100.0);
  ASSERT_TRUE(left.seconds());
  for (int i = 31; i <= 90; ++i) left.update(i, 0.3);
  EXPECT_FALSE(left.seconds());
}

}  // namespace
}  // namespace talus
