#include "base/trials.hpp"

#include <gtest/gtest.h>

namespace talus {
namespace {

/// How many chances go by until one is due.
int left_out(Trials& trials) {
  int count = 0;
  while (!trials.is_due()) ++count;
  return count;
}

TEST(Trials, LeaveOutMoreAfterEachFailureAndNoneAfterASuccess) {
  Trials trials;
  EXPECT_EQ(left_out(trials), 0);
  trials.note(true);
  EXPECT_EQ(left_out(trials), 0);
  for (const int expected : {1, 3, 7, 15, 31, 31}) {
    trials.note(false);
    EXPECT_EQ(left_out(trials), expected);
  }
  trials.note(true);
  EXPECT_EQ(left_out(trials), 0);
}

}  // namespace
}  // namespace talus
