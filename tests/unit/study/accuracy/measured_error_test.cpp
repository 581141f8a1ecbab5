#include "study/accuracy/measured_error.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"

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

TEST(ErrorMeasure, IsOfWhatIsAskedForAlsoWhereSomethingIsExpected) {
  Project project;
  project.expect = {{"P1.displacement.x", 1, 2, 0.01, {}, ""}};
  StudyRun near = come_to(2), far = come_to(2);
  near.travel = {10, Vec3(3, 0, 4), 0, 0.5, 8.0};
  far.travel = {12, Vec3(6, 0, 4), 4, 0.4, {}};
  near.moments = {{"fall", 1, {}, {Voigt::Unit(0)}}};
  far.moments = {{"fall", 1, {}, {3 * Voigt::Unit(0)}}};
  const auto distance = [&](StudyMeasure measure) -> std::optional<double> {
    const ErrorMeasure errors(project, measure);
    EXPECT_FALSE(errors.known());
    const auto a = errors.mean_answer({far}), b = errors.mean_answer({near});
    if (!a || !b) return std::nullopt;
    return errors.between(*a, *b, *b);
  };
  EXPECT_DOUBLE_EQ(*distance(StudyMeasure::run_out), 0.2);
  EXPECT_DOUBLE_EQ(*distance(StudyMeasure::deposit), 1) << "5 m of 5 m";
  EXPECT_DOUBLE_EQ(*distance(StudyMeasure::start), 0.2);
  EXPECT_FALSE(distance(StudyMeasure::end)) << "one has not come to rest";
  EXPECT_DOUBLE_EQ(*distance(StudyMeasure::stress), 2);
}

TEST(StudyMeasure, IsReadByItsWord) {
  EXPECT_EQ(study_measure_from("run-out"), StudyMeasure::run_out);
  EXPECT_THROW(study_measure_from("beauty"), InputError);
}

}  // namespace
}  // namespace talus
