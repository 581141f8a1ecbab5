#include "orientation/set_statistics.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace talus {
namespace {

TEST(SetStatistics, GoBySetInTheOrderOfTheTable) {
  // Two planes 10° to either side of 45/90 along its dip, and one alone.
  const std::vector<MeasuredJoint> joints{{{35, 90}, "B"}, {{80, 200}, "A"}, {{55, 90}, "B"}};
  const std::vector<SetStatistics> sets = statistics_by_set(joints);
  ASSERT_EQ(sets.size(), 2u);
  EXPECT_EQ(sets[0].name, "B");
  EXPECT_THAT(sets[0].members, testing::ElementsAre(0, 2));
  EXPECT_NEAR(sets[0].mean_plane().dip, 45, 1e-9);
  EXPECT_NEAR(sets[0].mean_plane().dip_direction, 90, 1e-9);
  EXPECT_NEAR(sets[0].fisher.kappa.value(), 1 / (2 - 2 * std::cos(radians(10))), 1e-6);
  EXPECT_EQ(sets[1].name, "A");
  EXPECT_FALSE(sets[1].fisher.kappa);
}

}  // namespace
}  // namespace talus
