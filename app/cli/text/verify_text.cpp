#include "text/verify_text.hpp"

#include <sstream>

#include "text/paragraph.hpp"
#include "text/table.hpp"
#include "verification/finding_text.hpp"

namespace talus::cli {

namespace {

/// Widths are fixed because a case is printed as soon as it ends, before those of the next are known.
constexpr std::size_t quantity_width = 44, unit_width = 5, value_width = 13, error_width = 9;

std::string row_text(const std::string& quantity, const std::string& unit, const FindingWords& words) {
  std::string row = "  " + padded(quantity, quantity_width);
  if (width_of(quantity) > quantity_width) row += '\n' + std::string(2 + quantity_width, ' ');
  row += "  " + padded(unit, unit_width);
  for (const std::string* value : {&words.expected, &words.computed}) row += "  " + padded_left(*value, value_width);
  for (const std::string* value : {&words.error, &words.tolerance}) row += "  " + padded_left(*value, error_width);
  row += "  " + words.verdict;
  return row + '\n';
}

std::string indented(const std::string& text, const std::string& margin) {
  std::istringstream lines(text);
  std::string result;
  for (std::string line; std::getline(lines, line);) result += line.empty() ? "\n" : margin + line + '\n';
  return result;
}

std::string table_text(const CaseTable& content) {
  Table table(content.columns, alignment_of(content));
  for (const auto& row : content.rows) table.add(row);
  return "\n  " + content.title + '\n' + indented(table.text(), "    ");
}

std::string verdict_of(const CaseResult& result) {
  std::string text = result.passed() ? "passed" : "FAILED";
  text += " in " + number(result.seconds, 2) + " s";
  if (result.options.scale != 1) text += " at scale " + number(result.options.scale);
  return text;
}

}  // namespace

std::string case_columns() {
  return row_text("Quantity", "Unit", {"Expected", "Computed", "Error", "Tolerance", "Passed"});
}

std::string case_text(const CaseResult& result, bool tables) {
  std::string text = '\n' + result.name + ": " + result.title + ": " + verdict_of(result) + '\n';
  if (!result.failure.empty()) text += paragraph("came to no answer: " + result.failure, 2);
  for (const Finding& finding : result.outcome.findings)
    text += row_text(finding.quantity, finding.unit, words_of(finding));
  for (const Repetition& repetition : result.repetitions) text += paragraph(repetition_text(repetition), 2);
  for (const std::string& remark : result.outcome.remarks) text += paragraph("– " + remark, 2);
  if (!result.source.empty()) text += paragraph("Source: " + result.source, 2);
  if (tables)
    for (const CaseTable& table : result.outcome.tables) text += table_text(table);
  return text;
}

std::string list_text(const std::vector<KnownCase>& cases) {
  Table table({"Case", "Runs", "Title"}, "lll");
  for (const KnownCase& known : cases) table.add({known.name, known.takes_long ? "with --all" : "always", known.title});
  return table.text();
}

}  // namespace talus::cli
