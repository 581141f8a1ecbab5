#include "solve/struggle_advice.hpp"

#include <gmock/gmock.h>

namespace talus {
namespace {

using testing::HasSubstr;

TEST(StruggleAdvice, fits_the_cause) {
  const SolverSettings settings;
  Struggle struggle;
  for (const StruggleCause cause :
       {StruggleCause::many_iterations, StruggleCause::found_late, StruggleCause::not_settled}) {
    struggle.cause = cause;
    EXPECT_THAT(advice_for(struggle, 0.0012, settings), testing::AllOf(HasSubstr("time_step"), HasSubstr("0.0012 s")));
  }
  struggle.cause = StruggleCause::inverted;
  EXPECT_THAT(advice_for(struggle, 0.001, settings), testing::AllOf(HasSubstr("mesh"), HasSubstr("stiffer")));
}

TEST(StruggleAdvice, of_deep_contacts_has_to_do_with_their_stiffness) {
  SolverSettings settings;
  Struggle struggle;
  struggle.cause = StruggleCause::not_settled;
  struggle.relative_penetration = 0.1;
  EXPECT_THAT(advice_for(struggle, 0.001, settings), HasSubstr("penetration_tolerance"));
  settings.penetration_tolerance = 1e-4;
  EXPECT_THAT(advice_for(struggle, 0.001, settings), HasSubstr("contact_stiffness"));
}

TEST(StruggleAdvice, of_a_step_that_was_not_given_the_usual_iterations_is_to_give_them) {
  SolverSettings settings;
  settings.open_close_limit = 12;
  Struggle struggle;
  struggle.cause = StruggleCause::not_settled;
  EXPECT_THAT(advice_for(struggle, 0.001, settings), testing::AllOf(HasSubstr("open_close_limit"), HasSubstr("12")));
  struggle.cause = StruggleCause::many_iterations;
  EXPECT_THAT(advice_for(struggle, 0.001, settings), HasSubstr("time_step"));
}

}  // namespace
}  // namespace talus
