#include "verification/random/other_settings.hpp"

#include <gtest/gtest.h>

namespace talus {
namespace {

TEST(OtherSettings, LeaveTheSchemeAndTheAccuracyAsTheyAre) {
  SolverSettings given;
  given.tolerance = reference_tolerance.value;
  given.contact_stiffness = 7;
  SceneNumbers numbers(1);
  for (int i = 0; i < 200; ++i) {
    SolverSettings drawn = other_settings(numbers, given);
    EXPECT_LE(drawn.penetration_tolerance.value_or(5e-4), 5e-4 * (1 + 1e-12));
    EXPECT_EQ(drawn.sleep_tolerance.value_or(0), 0);
    EXPECT_GE(drawn.open_close_limit, given.open_close_limit / 2);
    EXPECT_NE(drawn.effects.contact, Switch::off);
    EXPECT_NE(drawn.effects.missed_contacts, Switch::off);
    drawn.penetration_tolerance = given.penetration_tolerance;
    drawn.sleep_tolerance = given.sleep_tolerance;
    drawn.open_close_limit = given.open_close_limit;
    drawn.adaptive = given.adaptive;
    drawn.effects = given.effects;
    EXPECT_EQ(drawn, given) << "nothing else is drawn";
  }
}

TEST(OtherSettings, AreNamedWhereTheyDiffer) {
  SolverSettings before, after;
  EXPECT_EQ(changed_settings(before, after), "");
  after.penetration_tolerance = 1e-4;
  after.effects.elimination = Switch::off;
  after.adaptive.iterations = 5;
  EXPECT_EQ(changed_settings(before, after), "penetration_tolerance 0.0001, elimination off");
  after.time_step_control = TimeStepControl::adaptive;
  EXPECT_EQ(changed_settings(before, after), "penetration_tolerance 0.0001, iterations 5, elimination off");
}

}  // namespace
}  // namespace talus
