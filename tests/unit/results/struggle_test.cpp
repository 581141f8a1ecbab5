#include "results/struggle.hpp"

#include <gmock/gmock.h>

namespace talus {
namespace {

Struggle hard_step(const std::string& a, const std::string& b, int iterations, int cuts) {
  Struggle struggle;
  struggle.blocks = {a, b};
  struggle.iterations = struggle.most_iterations = iterations;
  struggle.cuts = cuts;
  struggle.cause = cuts > 0 ? StruggleCause::not_settled : StruggleCause::many_iterations;
  return struggle;
}

TEST(Struggle, says_what_happened_when_where_and_what_to_change) {
  Struggle struggle = hard_step("base", "cube", 7, 1);
  struggle.joint = "J1";
  struggle.position = Vec3(1.23456, -2, 1e-7);
  struggle.time = 0.25;
  struggle.advice = "turn the other way";
  EXPECT_EQ(failure_text(struggle),
            "the open-close iteration did not settle at t = 0.25 s: contact base – cube at (1.235, -2, 1e-07) m, joint "
            "J1; turn the other way");
  struggle.blocks = {"cube", ""};
  struggle.joint = "";
  EXPECT_EQ(contact_text(struggle), "block cube");
  struggle.cause = StruggleCause::inverted;
  EXPECT_EQ(failure_text(struggle),
            "a tetrahedron of block cube turned inside out at t = 0.25 s at (1.235, -2, 1e-07) m; turn the other way");
  struggle.blocks = {};
  struggle.cause = StruggleCause::not_settled;
  EXPECT_EQ(failure_text(struggle), "the open-close iteration did not settle at t = 0.25 s; turn the other way");
}

TEST(StruggleList, gathers_what_two_blocks_cost_and_keeps_where_it_was_hardest) {
  StruggleList list;
  EXPECT_TRUE(list.empty());
  Struggle slow = hard_step("A", "B", 40, 0);
  slow.time = 1;
  Struggle cut = hard_step("A", "B", 30, 1);
  cut.time = 2;
  for (const Struggle& one : {slow, cut, slow}) list.add(one);
  const auto hardest = list.hardest();
  ASSERT_EQ(hardest.size(), 1u);
  EXPECT_EQ(hardest[0].iterations, 110);
  EXPECT_EQ(hardest[0].cuts, 1);
  EXPECT_EQ(hardest[0].cause, StruggleCause::not_settled);
  EXPECT_EQ(hardest[0].time, 2);
}

TEST(StruggleList, has_where_the_run_ended_first_then_by_cuts_and_iterations_and_only_the_worst_few) {
  StruggleList list;
  for (int i = 0; i < 9; ++i) list.add(hard_step("A", "B" + std::to_string(i), 30 + i, i == 4 ? 2 : 0));
  Struggle end = hard_step("C", "", 5, 0);
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
