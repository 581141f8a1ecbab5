#include "verification/hard_cases/expectations.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

#include "verification/hard_cases/scenes/all_hard_cases.hpp"
#include "verification/known_answers/support/scene.hpp"

namespace talus {
namespace {

using testing::HasSubstr;

constexpr double quarter_turn = 1.5707963267948966;

/// A slab and a block of 1 m; the block's centroid starts at (0.5, 0, 0.5).
CaseScene block_on_slab() {
  CaseScene scene = rock_scene(30);
  scene.add_fixed_box("slab", Vec3(-4, -3, -1), Vec3(8, 3, 0));
  scene.add_box("block", Vec3(0, -0.5, 0), Vec3(1, 0.5, 1));
  return scene;
}

struct Expectations : testing::Test {
  const CaseScene scene = block_on_slab();
  Trajectory trajectory{scene.system,
                        {snapshot(0, -1), snapshot(1, 0), snapshot(2, 0), snapshot(3, 1), snapshot(4, 1)}};

  static Snapshot snapshot(double time, int stage) { return {time, stage, std::vector<BlockMotion>(2)}; }
  BlockMotion& block(int snapshot) { return trajectory.snapshots[snapshot].blocks[1]; }
  std::string fault(const HardCaseExpectation& expectation) const { return expectation.fault(trajectory); }
};

TEST_F(Expectations, RestIsHeldFromTheEndOfTheStageInAllSnapshots) {
  block(1).displacement.x() = 5;  // before the end of the stage
  EXPECT_EQ(fault(rests("block", 0, 1e-6)), "");
  EXPECT_THAT(fault(rests("block", -1, 1e-6)), HasSubstr("moves by 5 m"));
  block(3).displacement.z() = 2e-6;  // and back again
  EXPECT_THAT(fault(rests("block", 0, 1e-6)), HasSubstr("moves by 2e-06 m"));
  EXPECT_EQ(fault(rests("block", 0, 3e-6)), "");
  EXPECT_EQ(fault(rests("block", 1, 1e-6)), "");
}

TEST_F(Expectations, ABlockThatTurnsInPlaceDoesNotRest) {
  block(4).rotation = quarter_turn / 900;
  EXPECT_THAT(fault(rests("block", 0, 1e-6)), HasSubstr("turns by 0.1°"));
  EXPECT_EQ(fault(rests("block", 0, 1e-6, 0.2)), "");
}

TEST_F(Expectations, AllRestNamesTheOneThatDoesNot) {
  EXPECT_EQ(fault(all_rest(0, 1e-6)), "");
  block(4).displacement.y() = 1;
  EXPECT_THAT(fault(all_rest(0, 1e-6)), HasSubstr("block moves by 1 m"));
}

TEST_F(Expectations, DisplacementsAreMeasuredAlongTheDirectionAtTheEnd) {
  block(3).displacement = Vec3(9, 0, 0);
  block(2).displacement = Vec3(1, 0, 0);
  block(4).displacement = Vec3(3, 4, 0);
  EXPECT_EQ(fault(travels("block", Vec3(1, 0, 0), 2, 1e-9, 0)), "");
  EXPECT_EQ(fault(travels("block", Vec3(1, 0, 0), 3.02, 0.01)), "");
  EXPECT_EQ(fault(travels("block", Vec3(0.6, 0.8, 0), 5, 1e-9)), "");
  EXPECT_EQ(fault(travels("block", Vec3(-1, 0, 0), 3.04, 0.01)), "block goes -3 m");
  EXPECT_EQ(fault(travels("block", Vec3(1, 0, 0), 3.04, 0.01)), "block goes 3 m");
  EXPECT_EQ(fault(travels_at_least("block", Vec3(0, 1, 0), 4)), "");
  EXPECT_EQ(fault(travels_at_least("block", Vec3(0, 1, 0), 4.1)), "block goes 4 m");
}

TEST_F(Expectations, AccelerationIsThatOfDisplacementsInTheSecondHalfOfTheLastStage) {
  trajectory.snapshots.resize(3);
  for (int i = 0; i <= 200; ++i) {
    const double t = 0.01 * i, swing = 1e-5 * std::sin(700 * t);  // which makes 7e-3 m/s
    trajectory.snapshots.push_back(snapshot(2 + t, 1));
    block(3 + i).displacement = Vec3(t < 1 ? 9 : 0.3 * t + 0.1 * t * t + swing, -t * t, 0);
  }
  EXPECT_EQ(fault(accelerates("block", Vec3(1, 0, 0), 0.2, 2e-4)), "");
  EXPECT_EQ(fault(accelerates("block", Vec3(0, 1, 0), -2, 1e-12)), "");
  EXPECT_EQ(fault(accelerates("block", Vec3(0, 1, 0), -2.03, 0.01)), "block is accelerated by -2 m/s²");
}

TEST_F(Expectations, ABlockHasToppledWhenItEverTurnedThatFar) {
  block(3).rotation = quarter_turn;
  EXPECT_EQ(fault(topples("block", 89)), "");
  EXPECT_EQ(fault(topples("block", 91)), "block turns by 90°");
}

TEST_F(Expectations, ABlockStopsByTheEnd) {
  block(3).velocity = Vec3(0, 0, 2);
  EXPECT_EQ(fault(stops("block", 0.1)), "");
  block(4).velocity = Vec3(0, 0, 2);
  EXPECT_EQ(fault(stops("block", 0.1)), "block ends with 2 m/s");
}

TEST_F(Expectations, ABlockThatSpeedsUpIsFound) {
  block(2).velocity = block(3).velocity = Vec3(0, 0, 2);
  block(4).velocity = Vec3(0, 2.5, 0);
  EXPECT_EQ(fault(gains_no_speed("block", 1.5, 0.6)), "");
  EXPECT_EQ(fault(gains_no_speed("block", 1.5, 0.1)), "block gains 0.5 m/s");
}

TEST_F(Expectations, NothingThatMayMoveEverPassesThePlane) {
  const HardCaseExpectation above = stays_before(Vec3::Zero(), Vec3(0, 0, 1));
  EXPECT_EQ(fault(above), "") << "the slab below is fixed";
  block(2).displacement.z() = -0.6;
  EXPECT_THAT(fault(above), HasSubstr("block is 0.1 m behind it at 2 s"));
}

TEST_F(Expectations, ABlockThatSinksHasGoneAsideOrTurnedOver) {
  const HardCaseExpectation aside = comes_down_aside("block", Vec3(0, 0, 1), 0.1);
  block(2).displacement = Vec3(0, 0, -0.09);
  EXPECT_EQ(fault(aside), "") << "within its allowance";
  block(2).displacement = Vec3(0, 0, -1.1);
  EXPECT_EQ(fault(aside), "block sank by 1 m more than it may at 2 s, 0 m aside");
  block(2).displacement.x() = 0.049;
  EXPECT_NE(fault(aside), "");
  block(2).displacement.x() = 0.051;
  EXPECT_EQ(fault(aside), "") << "a twentieth of what it sank";
  block(2).displacement.x() = 0;
  block(2).rotation = quarter_turn / 17;
  EXPECT_EQ(fault(aside), "") << "it turned by more than 5°";
  block(2).rotation = quarter_turn / 19;
  EXPECT_NE(fault(aside), "");
}

TEST_F(Expectations, WhatIsNoNumberMeetsNoExpectation) {
  block(4).displacement.setConstant(std::numeric_limits<double>::quiet_NaN());
  block(4).velocity.setConstant(std::numeric_limits<double>::quiet_NaN());
  for (const HardCaseExpectation& expectation :
       {travels("block", Vec3(1, 0, 0), 0, 1), travels_at_least("block", Vec3(1, 0, 0), -1), stops("block", 1),
        gains_no_speed("block", 0, 1), stays_before(Vec3::Zero(), Vec3(0, 0, 1)), rests("block", 0, 1)})
    EXPECT_NE(fault(expectation), "") << expectation.words;
}

TEST_F(Expectations, ABlockOrStageThatIsNotThereIsOurMistake) {
  EXPECT_THROW(fault(rests("brick", 0, 1)), std::logic_error);
  EXPECT_THROW(fault(rests("block", 2, 1)), std::logic_error);
}

TEST_F(Expectations, SayWhatTheyExpect) {
  EXPECT_EQ(rests("block", -1, 1e-6).words,
            "block rests from the start on: moves by less than 1e-06 m, turns by less than 0.01°");
  EXPECT_EQ(stays_before(Vec3(0, 0.5, -5), Vec3(0, 0, 1)).words, "nothing passes through the plane at (0, 0.5, -5) m");
  EXPECT_EQ(travels("block", Vec3(1, 0, 0), 2, 0.05).words, "block goes 2 m within 5 %");
}

TEST(HardCaseScenes, HaveNamesOfTheirOwnGroupsTitlesAndExpectations) {
  std::set<std::string> names;
  for (const HardCase& scene : hard_cases()) {
    EXPECT_TRUE(names.insert(scene.name).second) << scene.name;
    EXPECT_THAT(scene.name, testing::MatchesRegex("[a-z0-9_]+"));
    EXPECT_FALSE(scene.group.empty()) << scene.name;
    EXPECT_FALSE(scene.title.empty()) << scene.name;
    EXPECT_FALSE(scene.expected.empty()) << scene.name;
  }
}

}  // namespace
}  // namespace talus
