#include <nlohmann/json.hpp>

#include "model/number_text.hpp"
#include "study/cases/case_study.hpp"
#include "study/cases/value_table.hpp"

namespace talus {

namespace {

using Json = nlohmann::ordered_json;

std::string status_of(const CaseRow& row) { return row.findings ? row.findings->status : "missing"; }

/// The cells of a row: case, project, status, the table's values, the numbers, reason.
std::vector<std::string> cells_of_row(const CaseStudy& study, const CaseRow& row) {
  std::vector<std::string> cells{row.name, row.project, status_of(row)};
  for (std::size_t i = 0; i < study.columns.size(); ++i) cells.push_back(value_as_cell(row.values[i]));
  for (const std::string& name : study.numbers) {
    const auto value = row.findings ? row.findings->number(name) : std::nullopt;
    cells.push_back(value ? number_text(*value) : std::string());
  }
  cells.push_back(row.findings ? row.findings->reason : std::string());
  return cells;
}

std::vector<std::string> headings_of(const CaseStudy& study) {
  std::vector<std::string> cells{"case", "project", "status"};
  cells.insert(cells.end(), study.columns.begin(), study.columns.end());
  cells.insert(cells.end(), study.numbers.begin(), study.numbers.end());
  cells.push_back("reason");
  return cells;
}

/// In quotes where a comma or a quote would end it.
std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c == '\n' ? ' ' : c);
  return quoted + '"';
}

std::string csv_line(const std::vector<std::string>& cells) {
  std::string line;
  for (const std::string& cell : cells) line += (&cell == &cells.front() ? "" : ",") + csv_cell(cell);
  return line + "\n";
}

std::string markdown_line(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) {
    line += ' ';
    for (const char c : cell) line += c == '|' ? "\\|" : std::string(1, c == '\n' ? ' ' : c);
    line += " |";
  }
  return line + "\n";
}

std::string markdown_head(const std::vector<std::string>& headings) {
  return markdown_line(headings) + markdown_line(std::vector<std::string>(headings.size(), "---"));
}

Json json_of(const CaseStudy& study, const CaseRow& row) {
  Json values = Json::object(), numbers = Json::object();
  for (std::size_t i = 0; i < study.columns.size(); ++i)
    values[study.columns[i]] = row.values[i].empty() ? Json() : Json::parse(row.values[i]);
  if (row.findings)
    for (const CaseNumber& one : row.findings->numbers) numbers[one.name] = one.value;
  return {{"case", row.name},         {"project", row.project},
          {"status", status_of(row)}, {"reason", row.findings ? row.findings->reason : ""},
          {"values", values},         {"numbers", numbers}};
}

Json json_of(const CaseStatistics& one) {
  return {{"count", one.count}, {"mean", one.mean},        {"deviation", one.deviation},
          {"least", one.least}, {"p10", one.p10},          {"median", one.median},
          {"p90", one.p90},     {"greatest", one.greatest}};
}

}  // namespace

std::string cases_csv(const CaseStudy& study) {
  std::string text = csv_line(headings_of(study));
  for (const CaseRow& row : study.rows) text += csv_line(cells_of_row(study, row));
  return text;
}

std::string cases_json(const CaseStudy& study) {
  Json cases = Json::array(), statistics = Json::object();
  for (const CaseRow& row : study.rows) cases.push_back(json_of(study, row));
  for (const CaseStatistics& one : study.statistics) statistics[one.name] = json_of(one);
  const Json json = {{"complete", study.missing() == 0},
                     {"completed", study.with_status("completed")},
                     {"columns", study.columns},
                     {"cases", cases},
                     {"statistics", statistics}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string cases_markdown(const CaseStudy& study) {
  std::string text = markdown_head(headings_of(study));
  for (const CaseRow& row : study.rows) text += markdown_line(cells_of_row(study, row));
  if (study.statistics.empty()) return text;
  text += "\n" + markdown_head({"of completed cases", "count", "mean", "standard deviation", "least", "10 %", "median",
                                "90 %", "greatest"});
  for (const CaseStatistics& one : study.statistics)
    text += markdown_line({one.name, std::to_string(one.count), significant(one.mean, 5), significant(one.deviation),
                           significant(one.least, 5), significant(one.p10, 5), significant(one.median, 5),
                           significant(one.p90, 5), significant(one.greatest, 5)});
  return text;
}

void write_case_files(const CaseStudy& study, const CaseFolder& folder) {
  folder.write("cases.csv", cases_csv(study));
  folder.write("cases.json", cases_json(study));
  folder.write("cases.md", cases_markdown(study));
}

}  // namespace talus
