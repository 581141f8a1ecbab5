#include "solve/trouble_advice.hpp"

#include <gmock/gmock.h>

namespace talus {
namespace {

using testing::HasSubstr;

TEST(TroubleAdvice, FitsTheCause) {
  const SolverSettings settings;
  ConvergenceTrouble trouble;
  for (const TroubleCause cause :
       {TroubleCause::many_iterations, TroubleCause::missed_contact, TroubleCause::not_converged}) {
    trouble.cause = cause;
    EXPECT_THAT(advice_for(trouble, 0.0012, settings), testing::AllOf(HasSubstr("time_step"), HasSubstr("0.0012 s")));
  }
  trouble.cause = TroubleCause::inverted;
  EXPECT_THAT(advice_for(trouble, 0.001, settings), testing::AllOf(HasSubstr("mesh"), HasSubstr("stiffer")));
}

TEST(TroubleAdvice, OfAChipIsToMergeIt) {
  const SolverSettings settings;
  ConvergenceTrouble trouble;
  for (const TroubleCause cause : {TroubleCause::many_iterations, TroubleCause::not_converged}) {
    trouble.cause = cause;
    EXPECT_THAT(advice_for(trouble, 0.001, settings, Chip{"rock.500", 0.002}),
                testing::AllOf(HasSubstr("rock.500 is a chip"), HasSubstr("splinters"), HasSubstr("0.0022 m")));
  }
}

TEST(TroubleAdvice, OfDeepContactsHasToDoWithTheirStiffness) {
  SolverSettings settings;
  ConvergenceTrouble trouble;
  trouble.cause = TroubleCause::not_converged;
  trouble.relative_penetration = 0.1;
  EXPECT_THAT(advice_for(trouble, 0.001, settings), HasSubstr("penetration_tolerance"));
  settings.penetration_tolerance = 1e-4;
  EXPECT_THAT(advice_for(trouble, 0.001, settings), HasSubstr("contact_stiffness"));
}

TEST(TroubleAdvice, OfAStepThatWasNotGivenTheUsualIterationsIsToGiveThem) {
  SolverSettings settings;
  settings.open_close_limit = 12;
  ConvergenceTrouble trouble;
  trouble.cause = TroubleCause::not_converged;
  EXPECT_THAT(advice_for(trouble, 0.001, settings), testing::AllOf(HasSubstr("open_close_limit"), HasSubstr("12")));
  trouble.cause = TroubleCause::many_iterations;
  EXPECT_THAT(advice_for(trouble, 0.001, settings), HasSubstr("time_step"));
}

}  // namespace
}  // namespace talus
