#include "verification/known_answers_page.hpp"

#include <algorithm>
#include <cmath>

#include "model/number_text.hpp"
#include "verification/finding_text.hpp"
#include "verification/markdown_table.hpp"
#include "verification/named_runs.hpp"

namespace talus {

namespace {

/// How near the worst held number comes to its tolerance, in %; "–" where that is no number. Far below, it is rounding.
std::string margin_text(const CaseResult& result) {
  double worst = 0;
  for (const Finding& finding : result.outcome.findings)
    if (!finding.reported && !(finding.error() <= 0)) worst = std::max(worst, finding.error() / finding.tolerance);
  if (!std::isfinite(worst) || result.outcome.findings.empty()) return "–";
  return worst > 0 && worst < 1e-4 ? "< 0.01" : significant(100 * worst, 2);
}

/// The link to a heading, as GitHub makes it.
std::string anchor_of(const std::string& heading) {
  std::string anchor;
  std::copy_if(heading.begin(), heading.end(), std::back_inserter(anchor), [](char c) { return c != '/'; });
  return anchor;
}

std::string findings_text(const std::vector<Finding>& findings) {
  if (findings.empty()) return {};
  std::string text =
      markdown_heading({"Quantity", "Unit", "Expected", "Computed", "Error", "Tolerance", "Passed"}, "llrrrrl");
  for (const Finding& finding : findings) {
    const FindingWords words = words_of(finding);
    text += markdown_row(
        {finding.quantity, finding.unit, words.expected, words.computed, words.error, words.tolerance, words.verdict});
  }
  return text + '\n';
}

std::string table_text(const CaseTable& table) {
  std::string text =
      markdown_paragraph(table.title + ":") + '\n' + markdown_heading(table.columns, alignment_of(table));
  for (const auto& row : table.rows) text += markdown_row(row);
  return text + '\n';
}

}  // namespace

std::string overview_row(const CaseResult& result) {
  const auto held = std::count_if(result.outcome.findings.begin(), result.outcome.findings.end(),
                                  [](const Finding& finding) { return !finding.reported; });
  return markdown_row({'[' + result.name + "](#" + anchor_of(result.name) + ')', result.title, std::to_string(held),
                       margin_text(result), result.passed() ? "yes" : "**no**"});
}

std::string case_section(const CaseResult& result) {
  const std::string source = result.source.empty() ? "" : " Source: " + result.source + ".";
  std::string text = "### " + result.name + "\n\n" + markdown_paragraph(result.title + "." + source) + '\n';
  if (!result.failure.empty()) text += markdown_paragraph("**Came to no answer**: " + result.failure) + '\n';
  text += findings_text(result.outcome.findings);
  for (const Repetition& repetition : result.repetitions)
    text += markdown_paragraph("- " + repetition_text(repetition), "  ");
  for (const std::string& remark : result.outcome.remarks) text += markdown_paragraph("- " + remark, "  ");
  if (!result.repetitions.empty() || !result.outcome.remarks.empty()) text += '\n';
  for (const CaseTable& table : result.outcome.tables) text += table_text(table);
  return text;
}

std::string known_answers_page(const std::vector<CaseResult>& results) {
  std::string text = passed_text("cases", results) + "\n\n" +
                     markdown_heading({"Case", "What", "Numbers held", "Error, % of tolerance", "Passed"}, "llrrl");
  for (const CaseResult& result : results) text += overview_row(result);
  text += '\n';
  for (const CaseResult& result : results) text += case_section(result);
  return text;
}

}  // namespace talus
