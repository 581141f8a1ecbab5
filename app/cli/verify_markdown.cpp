#include "verify_markdown.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>

#include "base/error.hpp"
#include "table.hpp"
#include "verify_text.hpp"

namespace talus::cli {

namespace {

const std::string begin_line = "<!-- talus-cli verify: begin -->\n", end_line = "<!-- talus-cli verify: end -->\n";

/// A cell that does not end the table's row.
std::string cell(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '|') escaped += '\\';
    escaped += c == '\n' ? ' ' : c;
  }
  return escaped;
}

std::string row_text(const std::vector<std::string>& cells) {
  std::string row = "|";
  for (const std::string& text : cells) row += ' ' + cell(text) + " |";
  return row + '\n';
}

std::string heading_text(const std::vector<std::string>& columns, const std::string& alignment) {
  std::string rule = "|";
  for (const char letter : alignment) rule += letter == 'r' ? "--:|" : "---|";
  return row_text(columns) + rule + '\n';
}

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
      verdict_text(results).substr(1) + '\n' +
      heading_text({"Case", "What", "Numbers held", "Error, % of tolerance", "Seconds", "Passed"}, "llrrrl");
  for (const CaseResult& result : results) {
    const auto held = std::count_if(result.outcome.findings.begin(), result.outcome.findings.end(),
                                    [](const Finding& finding) { return !finding.reported; });
    text += row_text({'[' + result.name + "](#" + anchor_of(result.name) + ')', result.title, std::to_string(held),
                      margin_text(result), number(result.seconds, 2), result.passed() ? "yes" : "**no**"});
  }
  return text;
}

std::string findings_text(const std::vector<Finding>& findings) {
  if (findings.empty()) return {};
  std::string text =
      heading_text({"Quantity", "Unit", "Expected", "Computed", "Error", "Tolerance", "Passed"}, "llrrrrl");
  for (const Finding& finding : findings) {
    const FindingWords words = words_of(finding);
    text += row_text(
        {finding.quantity, finding.unit, words.expected, words.computed, words.error, words.tolerance, words.verdict});
  }
  return text + '\n';
}

std::string table_text(const CaseTable& table) {
  std::string text = table.title + ":\n\n" + heading_text(table.columns, alignment_of(table));
  for (const auto& row : table.rows) text += row_text(row);
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

struct Page {
  std::string before, after;  ///< the generated part, with its marker lines
};

Page page_in(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  const std::string page = text.str();
  const std::size_t begin = page.find(begin_line), end = page.find(end_line);
  if (begin == std::string::npos || end == std::string::npos || end < begin)
    throw InputError(file.string(), "has no part for the tables of verify",
                     "give a page that holds the lines <!-- talus-cli verify: begin --> and "
                     "<!-- talus-cli verify: end -->");
  return {page.substr(0, begin + begin_line.size()), page.substr(end)};
}

}  // namespace

void check_markdown(const std::filesystem::path& file) { page_in(file); }

void write_markdown(const std::filesystem::path& file, const std::vector<CaseResult>& results) {
  const Page page = page_in(file);
  std::string text = overview_text(results) + '\n';
  for (const CaseResult& result : results) text += case_text(result);
  std::ofstream stream(file);
  stream << page.before << '\n' << text << page.after;
  stream.close();
  if (!stream) throw InputError(file.string(), "cannot be written", "check the path and its permissions");
}

}  // namespace talus::cli
