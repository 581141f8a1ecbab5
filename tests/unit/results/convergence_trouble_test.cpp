#include "results/convergence_trouble.hpp"

#include <gmock/gmock.h>

namespace talus {
namespace {

ConvergenceTrouble hard_step(const std::string& a, const std::string& b, int iterations, int cuts) {
  ConvergenceTrouble trouble;
  trouble.blocks = {a, b};
  trouble.iterations = trouble.most_iterations = iterations;
  trouble.cuts = cuts;
  trouble.cause = cuts > 0 ? TroubleCause::not_converged : TroubleCause::many_iterations;
  return trouble;
}

TEST(ConvergenceTrouble, SaysWhatHappenedWhenWhereAndWhatToChange) {
  ConvergenceTrouble trouble = hard_step("base", "cube", 7, 1);
  trouble.joint = "J1";
  trouble.position = Vec3(1.23456, -2, 1e-7);
  trouble.time = 0.25;
  trouble.advice = "turn the other way";
  EXPECT_EQ(
      failure_text(trouble),
      "the open-close iteration did not converge at t = 0.25 s: contact base – cube at (1.235, -2, 1e-07) m, joint "
      "J1; turn the other way");
  trouble.blocks = {"cube", ""};
  trouble.joint = "";
  EXPECT_EQ(contact_text(trouble), "block cube");
  trouble.cause = TroubleCause::inverted;
  EXPECT_EQ(failure_text(trouble),
            "a tetrahedron of block cube turned inside out at t = 0.25 s at (1.235, -2, 1e-07) m; turn the other way");
  trouble.blocks = {};
  trouble.cause = TroubleCause::not_converged;
  EXPECT_EQ(failure_text(trouble), "the open-close iteration did not converge at t = 0.25 s; turn the other way");
}

TEST(TroubleList, GathersWhatTwoBlocksCostAndKeepsWhereItWasHardest) {
  TroubleList list;
  EXPECT_TRUE(list.empty());
  ConvergenceTrouble slow = hard_step("A", "B", 40, 0);
  slow.time = 1;
  ConvergenceTrouble cut = hard_step("A", "B", 30, 1);
  cut.time = 2;
  for (const ConvergenceTrouble& one : {slow, cut, slow}) list.add(one);
  const auto hardest = list.hardest();
  ASSERT_EQ(hardest.size(), 1u);
  EXPECT_EQ(hardest[0].iterations, 110);
  EXPECT_EQ(hardest[0].cuts, 1);
  EXPECT_EQ(hardest[0].cause, TroubleCause::not_converged);
  EXPECT_EQ(hardest[0].time, 2);
}

TEST(TroubleList, HasWhereTheRunEndedFirstThenByCutsAndIterationsAndOnlyTheWorstFew) {
  TroubleList list;
  for (int i = 0; i < 9; ++i) list.add(hard_step("A", "B" + std::to_string(i), 30 + i, i == 4 ? 2 : 0));
  ConvergenceTrouble end = hard_step("C", "", 5, 0);
  end.ended_run = true;
  list.add(end);
  const auto hardest = list.hardest(3);
  ASSERT_EQ(hardest.size(), 3u);
  EXPECT_EQ(hardest[0].blocks[0], "C");
  EXPECT_EQ(hardest[1].blocks[1], "B4");
  EXPECT_EQ(hardest[2].blocks[1], "B8");
}

}  // namespace
}  // namespace talus
