#include <gmock/gmock.h>

#include "verification/hard_cases_page.hpp"
#include "verification/known_answers_page.hpp"

namespace talus {
namespace {

using testing::HasSubstr;

CaseResult fall() {
  CaseResult result;
  result.name = "samples/fall";
  result.title = "A fall";
  result.source = "½gt²";
  result.seconds = 12.25;
  result.outcome.findings = {{"depth", "m", 4, 4.02, 0.01}, {"drift", "m", 0, 0.5, 1, true, true}};
  result.outcome.remarks = {"a remark"};
  result.outcome.tables = {{"Rows", {"name", "x"}, {{"a|b", "1"}}}};
  return result;
}

TEST(KnownAnswersPage, HasARowAndASectionACase) {
  EXPECT_EQ(overview_row(fall()), "| [samples/fall](#samplesfall) | A fall | 1 | 50 | yes |\n");
  EXPECT_EQ(case_section(fall()),
            "### samples/fall\n\nA fall. Source: ½gt².\n\n"
            "| Quantity | Unit | Expected | Computed | Error | Tolerance | Passed |\n"
            "|---|---|--:|--:|--:|--:|---|\n"
            "| depth | m | 4 | 4.02 | 0.005 | 0.01 | yes |\n"
            "| drift | m | 0 | 0.5 | ±0.5 | – | shown |\n\n"
            "- a remark\n\n"
            "Rows:\n\n| name | x |\n|---|--:|\n| a\\|b | 1 |\n\n");
  const std::string page = known_answers_page({fall()});
  EXPECT_THAT(page, testing::StartsWith("1 of 1 cases passed\n\n| Case |"));
  EXPECT_THAT(page, HasSubstr(overview_row(fall()) + "\n" + case_section(fall())));
  EXPECT_THAT(page, testing::Not(HasSubstr("12"))) << "seconds are not the same twice";
}

TEST(KnownAnswersPage, HasProseInLinesOf120Characters) {
  CaseResult result = fall();
  result.outcome.remarks = {std::string(60, 'a') + " ½" + std::string(54, 'b') + " c d",
                            std::string(117, 'a') + " - b"};
  EXPECT_THAT(case_section(result), HasSubstr("\n- " + std::string(60, 'a') + " ½" + std::string(54, 'b') +
                                              " c\n  d\n- " + std::string(117, 'a') + " -\n  b\n"));
}

TEST(KnownAnswersPage, CallsRoundingWhatIsFarBelowItsTolerance) {
  CaseResult result = fall();
  result.outcome.findings[0].computed = 4 + 1e-9;
  EXPECT_THAT(overview_row(result), HasSubstr("| < 0.01 |"));
  result.outcome.findings[0].computed = 5;
  EXPECT_THAT(overview_row(result), HasSubstr("| 2.5e+03 | **no** |"));
}

Trial trial(const std::string& name, const std::string& group) {
  Trial one;
  one.name = name;
  one.group = group;
  one.title = "Title";
  one.source = "a paper";
  one.expected = {"it rests", "it stays"};
  one.steps = 4;
  one.iterations = 10;
  one.most_iterations = 5;
  one.cuts = 2;
  one.penetration = 1.234e-5;
  one.seconds = 12.25;
  return one;
}

TEST(HardCasesPage, HasATableAGroupWithoutSeconds) {
  EXPECT_EQ(trial_row(trial("spike", "shapes")),
            "| spike | Title (a paper) | it rests; it stays | completed | 1.2e-05 | 0 | 2.5 | 5 | 2 | yes |\n");
  Trial deep = trial("wall", "crowds");
  deep.penetration = 0.5;
  deep.known_shortfall = "the wall";
  const std::string page = hard_cases_page({trial("spike", "shapes"), deep});
  EXPECT_THAT(page, testing::StartsWith("1 of 2 scenes passed\n\n### shapes\n\n| Scene |"));
  EXPECT_THAT(page, HasSubstr("\n" + trial_row(trial("spike", "shapes")) + "\n### crowds\n"));
  EXPECT_THAT(page, HasSubstr("- **wall**: contacts are 0.5 of the mesh size deep (the wall)\n"));
}

}  // namespace
}  // namespace talus
