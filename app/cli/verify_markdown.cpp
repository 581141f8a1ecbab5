#include "verify_markdown.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "list_of_runs.hpp"
#include "table.hpp"
#include "verify_text.hpp"

namespace talus::cli {

namespace {

/// How near the worst held number comes to its tolerance, in %; "–" where that is no number.
std::string margin_text(const CaseResult& result) {
  double worst = 0;
  for (const Finding& finding : result.outcome.findings)
    if (!finding.reported && !(finding.error() <= 0)) worst = std::max(worst, finding.error() / finding.tolerance);
  return std::isfinite(worst) && !result.outcome.findings.empty() ? number(100 * worst, 2) : "–";
}

/// The link to a heading, as GitHub makes it.
std::string anchor_of(const std::string& heading) {
  std::string anchor;
  std::copy_if(heading.begin(), heading.end(), std::back_inserter(anchor), [](char c) { return c != '/'; });
  return anchor;
}

std::string overview_text(const std::vector<CaseResult>& results) {
  std::string text =
      verdict_text("cases", results) + '\n' +
      markdown_heading({"Case", "What", "Numbers held", "Error, % of tolerance", "Seconds", "Passed"}, "llrrrl");
  for (const CaseResult& result : results) {
    const auto held = std::count_if(result.outcome.findings.begin(), result.outcome.findings.end(),
                                    [](const Finding& finding) { return !finding.reported; });
    text += markdown_row({'[' + result.name + "](#" + anchor_of(result.name) + ')', result.title, std::to_string(held),
                          margin_text(result), number(result.seconds, 2), result.passed() ? "yes" : "**no**"});
  }
  return text;
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
  std::string text = table.title + ":\n\n" + markdown_heading(table.columns, alignment_of(table));
  for (const auto& row : table.rows) text += markdown_row(row);
  return text + '\n';
}

std::string case_text(const CaseResult& result) {
  std::string text = "### " + result.name + "\n\n" + result.title + ". ";
  if (!result.source.empty()) text += "Source: " + result.source + ".";
  text += "\n\n";
  if (!result.failure.empty()) text += "**Came to no answer**: " + result.failure + "\n\n";
  text += findings_text(result.outcome.findings);
  for (const Repetition& repetition : result.repetitions) text += "- " + repetition_text(repetition) + '\n';
  for (const std::string& remark : result.outcome.remarks) text += "- " + remark + '\n';
  if (!result.repetitions.empty() || !result.outcome.remarks.empty()) text += '\n';
  for (const CaseTable& table : result.outcome.tables) text += table_text(table);
  return text;
}

}  // namespace

std::string markdown_of(const std::vector<CaseResult>& results) {
  std::string text = overview_text(results) + '\n';
  for (const CaseResult& result : results) text += case_text(result);
  return text;
}

}  // namespace talus::cli
