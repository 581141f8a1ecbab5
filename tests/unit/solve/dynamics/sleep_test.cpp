#include "solve/dynamics/sleep.hpp"

#include <gmock/gmock.h>

#include <array>

#include "support/solver_scenes.hpp"

namespace talus {
namespace {

using testing::ElementsAre;

constexpr double step_length = 0.01;  // s, of a step
constexpr double tolerance = 1e-6;    // 1/s
constexpr double slow = 1e-9;         // m in a step: a tenth of what a block of 1 m may go
constexpr double fast = 1e-7;         // m in a step
const int slow_steps = SleepTolerances{}.slow_steps;

/// A fixed ground, body 0, and three blocks of 1 m that stand still until they are told to go.
class SleepOfThree : public testing::Test {
 protected:
  SleepOfThree() { sleep.begin_stage(std::vector<bool>(4, false)); }

  void touch(int a, int b, ContactMode mode = ContactMode::stick) {
    ContactPoint point{};
    point.bodies[0] = a;
    point.bodies[1] = b;
    point.mode = mode;
    contacts.points.push_back(point);
  }
  /// The bodies move by these displacements each step; true if some fell asleep.
  bool pass(int steps, std::array<double, 3> displacements = {slow, slow, slow}) {
    bool any = false;
    for (int i = 0; i < steps; ++i) {
      for (const int b : bodies.moving) bodies.bodies[b].largest_displacement = displacements[b - 1];
      if (sleep.after_step(bodies, contacts, step_length).empty()) continue;
      any = true;
      hold();
    }
    return any;
  }
  void rest(int a, int b) {
    RestingContact contact{};
    contact.bodies[0] = a;
    contact.bodies[1] = b;
    resting.push_back(contact);
  }
  void wake(int body, int rings) {
    sleep.wake(std::array{body}, resting, rings);
    hold();
  }
  void hold() { bodies.hold(std::vector<bool>(sleep.asleep().begin(), sleep.asleep().end())); }

  Project project = test::rock_project(30, {});
  BlockSystem system = test::block_system({test::box_block("ground", Vec3(0, 0, -1), Vec3(9, 1, 0), BodyKind::fixed),
                                           test::box_block("A", Vec3(0, 0, 0), Vec3(1, 1, 1)),
                                           test::box_block("B", Vec3(1, 0, 0), Vec3(2, 1, 1)),
                                           test::box_block("C", Vec3(4, 0, 0), Vec3(5, 1, 1))});
  BodySet bodies{project, system};
  ContactSet contacts;
  std::vector<RestingContact> resting;
  Sleep sleep{std::vector<double>(4, 1.0), tolerance};
};

TEST_F(SleepOfThree, BlockFallsAsleepAfterSomeSlowSteps) {
  EXPECT_FALSE(pass(slow_steps - 1));
  EXPECT_THAT(sleep.asleep(), ElementsAre(0, 0, 0, 0));
  EXPECT_TRUE(pass(1));
  EXPECT_THAT(sleep.asleep(), ElementsAre(0, 1, 1, 1));
  EXPECT_EQ(sleep.count(), 3);
}

TEST_F(SleepOfThree, SlownessDependsOnSpeedAndSizeAndNotOnTheStep) {
  EXPECT_TRUE(pass(slow_steps, {1.01 * tolerance * step_length, 0.99 * tolerance * step_length, fast}));
  EXPECT_THAT(sleep.asleep(), ElementsAre(0, 0, 1, 0));
}

TEST_F(SleepOfThree, BlockThatTurnsBackIsNotAtRest) {
  for (int swing = 0; swing < 10; ++swing) {
    EXPECT_FALSE(pass(slow_steps - 1));
    EXPECT_FALSE(pass(1, {fast, fast, fast}));
  }
}

TEST_F(SleepOfThree, NobodySleepsWhereTheToleranceIsZero) {
  Sleep none(std::vector<double>(4, 1.0), 0);
  for (int i = 0; i < 3 * slow_steps; ++i) EXPECT_TRUE(none.after_step(bodies, contacts, step_length).empty());
}

TEST_F(SleepOfThree, NobodySleepsWhereTheBaseIsMoved) {
  bodies.driven = {0};
  EXPECT_FALSE(pass(3 * slow_steps));
}

TEST_F(SleepOfThree, WhatSlidesHoweverSlowlyStaysAwake) {
  touch(1, 0, ContactMode::slip);
  touch(1, 2);
  EXPECT_TRUE(pass(slow_steps));
  EXPECT_THAT(sleep.asleep(), ElementsAre(0, 0, 1, 1));
}

TEST_F(SleepOfThree, TwoBlocksThatSlideOnEachOtherStayAwake) {
  touch(1, 2, ContactMode::slip);
  EXPECT_TRUE(pass(slow_steps));
  EXPECT_THAT(sleep.asleep(), ElementsAre(0, 0, 0, 1));
}

TEST_F(SleepOfThree, WhatBearsAChangingLoadStaysAwakeWithWhatItTouches) {
  sleep.begin_stage({false, false, true, false});
  touch(1, 2, ContactMode::open);
  EXPECT_TRUE(pass(slow_steps));
  EXPECT_THAT(sleep.asleep(), ElementsAre(0, 0, 0, 1));
}

TEST_F(SleepOfThree, FixedGroundDoesNotJoinWhatStandsOnIt) {
  touch(1, 0);
  touch(2, 0);
  EXPECT_TRUE(pass(2 * slow_steps, {slow, fast, slow}));
  EXPECT_THAT(sleep.asleep(), ElementsAre(0, 1, 0, 1));
}

TEST_F(SleepOfThree, BlockStaysAwakeBesideOneThatMovesAndNoFartherFromIt) {
  touch(1, 2);
  touch(2, 3, ContactMode::open);
  EXPECT_TRUE(pass(2 * slow_steps, {slow, slow, fast}));
  EXPECT_THAT(sleep.asleep(), ElementsAre(0, 1, 0, 0));
}

TEST_F(SleepOfThree, BlockFallsAsleepOnSleepers) {
  touch(1, 2);
  touch(2, 3);
  EXPECT_TRUE(pass(slow_steps, {slow, slow, fast}));
  EXPECT_TRUE(pass(slow_steps));
  EXPECT_THAT(sleep.asleep(), ElementsAre(0, 1, 1, 1));
}

TEST_F(SleepOfThree, WakesWithThoseUpToSoManyRingsAway) {
  EXPECT_TRUE(pass(slow_steps));
  rest(1, 0);
  rest(2, 1);
  rest(2, 3);
  wake(1, 1);
  EXPECT_THAT(sleep.asleep(), ElementsAre(0, 0, 1, 1));
  wake(1, 3);
  EXPECT_THAT(sleep.asleep(), ElementsAre(0, 0, 1, 1)) << "one who is awake woke others";
  wake(3, 2);
  EXPECT_THAT(sleep.asleep(), ElementsAre(0, 0, 0, 0));
  EXPECT_EQ(sleep.count(), 0);
  EXPECT_EQ(sleep.wakings(), 3);
}

TEST_F(SleepOfThree, WhoWakesNeedsAllItsSlowStepsAgain) {
  EXPECT_TRUE(pass(slow_steps, {slow, slow, fast}));
  wake(1, 1);
  EXPECT_THAT(sleep.asleep(), ElementsAre(0, 0, 1, 0));
  EXPECT_FALSE(pass(slow_steps - 1, {slow, slow, fast}));
  pass(slow_steps, {slow, slow, fast});
  EXPECT_THAT(sleep.asleep(), ElementsAre(0, 1, 1, 0));
}

}  // namespace
}  // namespace talus
