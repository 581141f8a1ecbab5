#include <gmock/gmock.h>

#include <algorithm>

#include "study/verify.hpp"

// Compiled twice: for the quick cases, and (TALUS_IN_FULL) for all of them with every row of those that are thinned.
namespace talus {
namespace {

std::vector<KnownCase> cases_of_this_program(BodyKind body = BodyKind::tetrahedra) {
  return chosen_cases(all_cases(std::filesystem::path(TALUS_SOURCE_DIR) / "samples"), {}, TALUS_IN_FULL, body);
}

void expect_passed(const CaseResult& result) {
  EXPECT_EQ(result.failure, "");
  for (const Finding& finding : result.outcome.findings)
    EXPECT_TRUE(finding.reported || finding.passed())
        << finding.quantity << ": expected " << finding.expected << ' ' << finding.unit << ", computed "
        << finding.computed << ", error " << finding.error() << ", tolerance " << finding.tolerance;
  EXPECT_TRUE(result.outcome.passed());
}

class KnownAnswer : public testing::TestWithParam<KnownCase> {};

#if TALUS_IN_FULL
TEST_P(KnownAnswer, IsComputedInFull) {
  NoProgress progress;
  VerifyOptions options;
  options.run.thorough = true;
  expect_passed(verify(GetParam(), options, progress));
}
#else
TEST_P(KnownAnswer, IsComputed) {
  NoProgress progress;
  expect_passed(verify(GetParam(), {}, progress));
}

TEST_P(KnownAnswer, IsTheSameOnTwoThreadsAndAtATenthOfTheScale) {
  NoProgress progress;
  VerifyOptions options;
  options.repeat = true;
  const CaseResult result = verify(GetParam(), options, progress);
  EXPECT_EQ(result.repetitions.size(), GetParam().scales ? 2U : 1U) << result.failure;
  for (const Repetition& repetition : result.repetitions)
    EXPECT_TRUE(repetition.passed) << repetition.options.threads << " threads, scale " << repetition.options.scale
                                   << ": " << repetition.failure << "; differs by " << repetition.largest.value << " ("
                                   << repetition.largest.quantity << "), about zero by " << repetition.about_zero.value
                                   << " of the tolerance (" << repetition.about_zero.quantity << ')';
}

/// Cases that ask for no strain, with blocks in one piece.
class KnownAnswerOfOnePiece : public KnownAnswer {};

void expect_passed_with(BodyKind body, const KnownCase& known) {
  NoProgress progress;
  VerifyOptions options;
  options.run.body = body;
  expect_passed(verify(known, options, progress));
}

TEST_P(KnownAnswerOfOnePiece, IsComputedWithRigidBlocks) { expect_passed_with(BodyKind::rigid, GetParam()); }
TEST_P(KnownAnswerOfOnePiece, IsComputedWithAffineBlocks) { expect_passed_with(BodyKind::affine, GetParam()); }
#endif

std::string test_name(const testing::TestParamInfo<KnownCase>& one) {
  std::string name = one.param.name;
  std::replace(name.begin(), name.end(), '/', '_');
  return name;
}

#if !TALUS_IN_FULL
INSTANTIATE_TEST_SUITE_P(, KnownAnswerOfOnePiece, testing::ValuesIn(cases_of_this_program(BodyKind::rigid)), test_name);
#endif
INSTANTIATE_TEST_SUITE_P(, KnownAnswer, testing::ValuesIn(cases_of_this_program()), test_name);

}  // namespace

/// For messages of GoogleTest.
void PrintTo(const KnownCase& known, std::ostream* stream) { *stream << known.name; }

}  // namespace talus
