#include "study/forecast/run_beginning.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace talus {
namespace {

/// A static stage that ends at equilibrium, and its first steps.
struct Beginning {
  Stage stage;
  StageBeginning seen;

  explicit Beginning(const std::vector<double>& out_of_balance) {
    stage.kind = StageKind::static_;
    stage.until_equilibrium = true;
    stage.equilibrium_tolerance = 1e-5;
    for (const double one : out_of_balance) seen.steps.push_back({.out_of_balance = one});
  }
};

TEST(StepsToEnd, FallOfWhatIsOutOfBalanceSaysWhenTheStageEnds) {
  std::vector<double> out_of_balance;
  for (int step = 0; step < 20; ++step) out_of_balance.push_back(std::pow(10, -0.1 * step));
  const Beginning beginning(out_of_balance);  // 10^-1.9 in the end, 10^-5 in 31 steps
  EXPECT_NEAR(steps_to_end(beginning.stage, beginning.seen, 1000), 31, 1e-6);
  EXPECT_NEAR(steps_to_end(beginning.stage, beginning.seen, 12), 12, 1e-6) << "no more than are left";
}

TEST(StepsToEnd, WithoutAFallTheyAreAllThatAreLeft) {
  for (const auto& out_of_balance : {std::vector{1.0, 0.5}, std::vector{1.0, 1.0, 1.0, 1.0, 1.0},
                                     std::vector{0.1, 0.2, 0.3, 0.4, 0.5}, std::vector{0.0, 0.0, 0.0, 0.0}}) {
    const Beginning beginning(out_of_balance);
    EXPECT_EQ(steps_to_end(beginning.stage, beginning.seen, 1000), 1000);
  }
  Beginning fixed({1, 0.1, 0.01, 1e-3, 1e-4});
  EXPECT_LT(steps_to_end(fixed.stage, fixed.seen, 1000), 1000);
  fixed.stage.until_equilibrium = false;
  EXPECT_EQ(steps_to_end(fixed.stage, fixed.seen, 1000), 1000);
}

}  // namespace
}  // namespace talus
