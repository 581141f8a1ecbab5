#include "study/accuracy/choice.hpp"

#include <gmock/gmock.h>

#include "base/error.hpp"

namespace talus {
namespace {

using Offers = std::vector<std::optional<CostAndError>>;

const Offers offers{CostAndError{1, 0.1}, CostAndError{2, 0.2},  CostAndError{3, 0.01},
                    std::nullopt,         CostAndError{3, 0.02}, CostAndError{9, 0.001}};

TEST(Choice, TheFrontIsWhatNothingCheaperBeats) {
  EXPECT_THAT(pareto_front(offers), testing::ElementsAre(true, false, true, false, false, true));
  EXPECT_THAT(pareto_front(Offers{CostAndError{1, 0}, CostAndError{1, 0}}), testing::ElementsAre(true, true));
  EXPECT_THAT(pareto_front(Offers{CostAndError{1, 0.1}, CostAndError{2, 0.1}, CostAndError{1, 0.2}}),
              testing::ElementsAre(true, false, false))
      << "dearer and no better, or worse and no cheaper";
}

TEST(Choice, TheCheapestWithinTheTargetIsTaken) {
  EXPECT_EQ(cheapest_within(0.5, offers), 0);
  EXPECT_EQ(cheapest_within(0.02, offers), 2);
  EXPECT_EQ(cheapest_within(0.001, offers), 5);
  EXPECT_EQ(cheapest_within(1e-4, offers), -1);
}

TEST(Choice, TargetsAreSharesOrPercent) {
  EXPECT_DOUBLE_EQ(parse_target("1%"), 0.01);
  EXPECT_DOUBLE_EQ(parse_target("0.5 %"), 0.005);
  EXPECT_DOUBLE_EQ(parse_target("0.01"), 0.01);
  for (const char* wrong : {"", "%", "-1%", "0", "1 m", "inf"}) EXPECT_THROW(parse_target(wrong), InputError) << wrong;
}

}  // namespace
}  // namespace talus
