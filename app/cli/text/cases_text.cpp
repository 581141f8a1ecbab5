#include "text/cases_text.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "study/cases/value_table.hpp"
#include "text/table.hpp"

namespace talus::cli {

namespace {

/// Numbers that a line has, with the heading that says their unit; the files have all.
constexpr std::array shown{
    std::pair<std::string_view, std::string_view>{"blocks", "Blocks"},
    std::pair<std::string_view, std::string_view>{"moved_blocks", "Moved"},
    std::pair<std::string_view, std::string_view>{"moved_volume", "Volume [m³]"},
    std::pair<std::string_view, std::string_view>{"farthest", "Farthest [m]"},
    std::pair<std::string_view, std::string_view>{"front", "Front [m]"},
    std::pair<std::string_view, std::string_view>{"travel_angle", "Angle [°]"},
    std::pair<std::string_view, std::string_view>{"cpu_seconds", "CPU [s]"},
};

/// "/joints/J1/friction_angle" is "J1 friction_angle" above a column of the screen.
std::string short_name(const std::string& column) {
  const auto last = column.rfind('/');
  const auto before = column.rfind('/', last - 1);
  if (last == 0 || before == std::string::npos) return column.substr(1);
  return column.substr(before + 1, last - before - 1) + ' ' + column.substr(last + 1);
}

std::string rows_text(const CaseStudy& study) {
  std::vector<std::string> headings{"Case", "Status"};
  std::string alignment = "ll";
  for (const std::string& column : study.columns) (headings.push_back(short_name(column)), alignment += 'r');
  for (const auto& [name, heading] : shown) (headings.emplace_back(heading), alignment += 'r');
  Table table(headings, alignment);
  for (const CaseRow& row : study.rows) {
    std::vector<std::string> cells{row.name, row.findings ? row.findings->status : "missing"};
    for (std::size_t i = 0; i < study.columns.size(); ++i)
      cells.push_back(row.values[i].empty() ? "–" : value_as_cell(row.values[i]));
    for (const auto& [name, heading] : shown) {
      const auto value = row.findings ? row.findings->number(std::string(name)) : std::nullopt;
      cells.push_back(value ? number(*value, 4) : "–");
    }
    table.add(cells);
  }
  return table.text();
}

/// Of the numbers that differ from case to case.
std::string statistics_text(const CaseStudy& study) {
  Table table({"Of completed cases", "Mean", "Deviation", "Least", "10 %", "Median", "90 %", "Greatest"}, "lrrrrrrr");
  for (const CaseStatistics& one : study.statistics)
    if (one.least < one.greatest)
      table.add({one.name, number(one.mean, 4), number(one.deviation, 3), number(one.least, 4), number(one.p10, 4),
                 number(one.median, 4), number(one.p90, 4), number(one.greatest, 4)});
  return table.text();
}

}  // namespace

std::string cases_text(const CaseStudy& study) {
  std::string text = rows_text(study) + '\n';
  if (study.with_status("completed") > 1) text += statistics_text(study) + '\n';
  for (const CaseRow& row : study.rows)
    if (row.findings && !row.findings->completed()) text += row.name + ": " + row.findings->reason + '\n';
  return text + std::to_string(study.with_status("completed")) + " of " + std::to_string(study.rows.size()) +
         " cases completed\n";
}

}  // namespace talus::cli
