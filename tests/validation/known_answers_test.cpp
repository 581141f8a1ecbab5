#include <gmock/gmock.h>

#include <algorithm>

#include "support/written_tables.hpp"
#include "verification/known_answers_page.hpp"
#include "verification/verify.hpp"

namespace talus {
namespace {

std::vector<KnownCase> cases_there_are() { return all_cases(std::filesystem::path(TALUS_SOURCE_DIR) / "samples"); }

std::vector<KnownCase> quick_cases(BodyKind body = BodyKind::tetrahedra) {
  return chosen_cases(cases_there_are(), {}, false, body);
}

void expect_passed(const CaseResult& result) {
  EXPECT_EQ(result.failure, "");
  for (const Finding& finding : result.outcome.findings)
    EXPECT_TRUE(finding.reported || finding.passed())
        << finding.quantity << ": expected " << finding.expected << ' ' << finding.unit << ", computed "
        << finding.computed << ", error " << finding.error() << ", tolerance " << finding.tolerance;
  EXPECT_TRUE(result.outcome.passed());
}

const std::string stale = test::how_to_mend("--all", "known_answers.md");

/// The table is written in full: of a case that was thinned, only what it is can be compared.
void expect_written(const KnownCase& known, const CaseResult& result) {
  static const test::WrittenPage page("known_answers.md");
  if (!test::has_arithmetic_of_tables()) return;
  std::string section = page.section(known.name), now = case_section(result);
  const std::string row = overview_row(result);
  if (known.thinned && !result.options.thorough) {
    for (std::string* text : {&section, &now}) text->resize(std::min(text->size(), text->find("\n\n|")));
    EXPECT_NE(section, "") << stale;
  } else {
    EXPECT_EQ(test::difference(page.row(row.substr(2, row.find(" |", 2) - 2)), row), "") << stale;
  }
  EXPECT_EQ(test::difference(section, now), "") << stale;
}

class KnownAnswer : public testing::TestWithParam<KnownCase> {};

TEST(KnownAnswersTable, HasASectionForEveryCase) {
  std::vector<std::string> sections, names;
  for (const std::string& name : test::WrittenPage("known_answers.md").names())
    if (name.starts_with("### ")) sections.push_back(name);
  for (const KnownCase& known : cases_there_are()) names.push_back("### " + known.name);
  EXPECT_EQ(sections, names) << stale;
}

/// All of them, with every row of those that are thinned.
class KnownAnswerInFull : public testing::TestWithParam<KnownCase> {};

TEST_P(KnownAnswerInFull, IsComputed) {
  NoProgress progress;
  VerifyOptions options;
  options.run.thorough = true;
  const CaseResult result = verify(GetParam(), options, progress);
  expect_passed(result);
  expect_written(GetParam(), result);
}

TEST_P(KnownAnswer, IsComputedTheSameOnTwoThreadsAndAtATenthOfTheScale) {
  NoProgress progress;
  VerifyOptions options;
  options.repeat = true;
  CaseResult result = verify(GetParam(), options, progress);
  EXPECT_EQ(result.repetitions.size(), GetParam().scales ? 2U : 1U) << result.failure;
  for (const Repetition& repetition : result.repetitions)
    EXPECT_TRUE(repetition.passed) << repetition.options.threads << " threads, scale " << repetition.options.scale
                                   << ": " << repetition.failure << "; differs by " << repetition.largest.value << " ("
                                   << repetition.largest.quantity << "), about zero by " << repetition.about_zero.value
                                   << " of the tolerance (" << repetition.about_zero.quantity << ')';
  result.repetitions.clear();  // the table is of the first run
  expect_passed(result);
  expect_written(GetParam(), result);
}

/// Cases that ask for no strain, with rigid and affine blocks.
class KnownAnswerOfSingleBody : public KnownAnswer {};

void expect_passed_with(BodyKind body, const KnownCase& known) {
  NoProgress progress;
  VerifyOptions options;
  options.run.body = body;
  expect_passed(verify(known, options, progress));
}

TEST_P(KnownAnswerOfSingleBody, IsComputedWithRigidBlocks) { expect_passed_with(BodyKind::rigid, GetParam()); }
TEST_P(KnownAnswerOfSingleBody, IsComputedWithAffineBlocks) { expect_passed_with(BodyKind::affine, GetParam()); }

std::string test_name(const testing::TestParamInfo<KnownCase>& one) {
  std::string name = one.param.name;
  std::replace(name.begin(), name.end(), '/', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(, KnownAnswer, testing::ValuesIn(quick_cases()), test_name);
INSTANTIATE_TEST_SUITE_P(, KnownAnswerOfSingleBody, testing::ValuesIn(quick_cases(BodyKind::rigid)), test_name);
INSTANTIATE_TEST_SUITE_P(Long, KnownAnswerInFull, testing::ValuesIn(chosen_cases(cases_there_are(), {}, true)),
                         test_name);

}  // namespace

/// For messages of GoogleTest.
void PrintTo(const KnownCase& known, std::ostream* stream) { *stream << known.name; }

}  // namespace talus
