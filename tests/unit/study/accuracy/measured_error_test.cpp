#include "study/accuracy/measured_error.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace talus {
namespace {

/// A run at whose only moment blocks have gone so far.
StudyRun gone(std::vector<Vec3> displacements) {
  StudyRun run;
  run.moments = {{"fall", 1, std::move(displacements)}};
  return run;
}

/// A run whose only expectation came to this.
StudyRun come_to(double value) {
  StudyRun run;
  run.expect.resize(1);
  run.expect[0].computed = value;
  run.expect[0].reached = true;
  return run;
}

TEST(ErrorMeasure, IsOfMeansAndTellsTheirSpread) {
  const ErrorMeasure measure(Project{});
  const auto one = measure.mean_answer({gone({Vec3(3, 0, 0)}), gone({Vec3(5, 0, 0)})});
  const auto reference = measure.mean_answer({gone({Vec3(2, 0, 0)}), gone({Vec3(2, 0, 0)})});
  ASSERT_TRUE(one && reference);
  EXPECT_DOUBLE_EQ(*measure.between(*one, *reference, *reference), 1) << "a mean of 4 m is held to one of 2 m";
  EXPECT_DOUBLE_EQ(measure.spread(*one, *reference), std::sqrt(2.0) / 2);
  EXPECT_EQ(measure.spread(*reference, *reference), 0);
}

TEST(ErrorMeasure, OfASingleRunHasNoSpread) {
  const ErrorMeasure measure(Project{});
  const auto one = measure.mean_answer({gone({Vec3(3, 0, 4)})});
  ASSERT_TRUE(one);
  EXPECT_EQ(measure.spread(*one, *one), 0);
}

TEST(ErrorMeasure, AddsUpTheSpreadOfAllBlocks) {
  const ErrorMeasure measure(Project{});
  const auto two = measure.mean_answer({gone({Vec3(3, 0, 0), Vec3(0, 4, 0)}), gone({Vec3(5, 0, 0), Vec3(0, 8, 0)})});
  ASSERT_TRUE(two);
  EXPECT_DOUBLE_EQ(measure.spread(*two, *two), std::sqrt((2.0 + 8.0) / (16 + 36)));
}

TEST(ErrorMeasure, HoldsTheMeanToWhatIsKnown) {
  Project project;
  project.expect = {{"P1.displacement.x", 1, 2, 0.01, {}, ""}};
  const ErrorMeasure measure(project);
  const auto answer = measure.mean_answer({come_to(2.1), come_to(1.7)});
  ASSERT_TRUE(answer);
  EXPECT_NEAR(*measure.from_known(*answer), 0.05, 1e-12);
  EXPECT_NEAR(measure.spread(*answer, *answer), 0.2 / std::sqrt(2.0), 1e-12);
}

TEST(ErrorMeasure, HasNoAnswerWhereOneRepeatHasNone) {
  const ErrorMeasure measure(Project{});
  StudyRun failed = gone({Vec3(1, 0, 0)});
  failed.status = StudyStatus::not_converged;
  EXPECT_FALSE(measure.mean_answer({gone({Vec3(1, 0, 0)}), failed}));
  EXPECT_FALSE(measure.mean_answer(std::vector<StudyRun>{}));
}

}  // namespace
}  // namespace talus
