#include "study/cases/case_study.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace talus {

namespace {

std::vector<std::string> numbers_of(const std::vector<CaseRow>& rows) {
  std::vector<std::string> names;
  for (const CaseRow& row : rows)
    if (row.findings)
      for (const CaseNumber& one : row.findings->numbers)
        if (std::ranges::find(names, one.name) == names.end()) names.push_back(one.name);
  return names;
}

std::optional<CaseStatistics> statistics_of(const std::string& name, const std::vector<CaseRow>& rows) {
  std::vector<double> values;
  for (const CaseRow& row : rows)
    if (row.findings && row.findings->completed())
      if (const auto value = row.findings->number(name)) values.push_back(*value);
  if (values.empty()) return std::nullopt;
  std::ranges::sort(values);
  const auto count = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  double squares = 0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return CaseStatistics{name,
                        static_cast<int>(values.size()),
                        mean,
                        values.size() > 1 ? std::sqrt(squares / (count - 1)) : 0,
                        values.front(),
                        quantile(values, 0.1),
                        quantile(values, 0.5),
                        quantile(values, 0.9),
                        values.back()};
}

}  // namespace

double quantile(const std::vector<double>& sorted, double part) {
  const double place = part * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  if (below + 1 >= sorted.size()) return sorted.back();
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[below + 1] - sorted[below]);
}

int CaseStudy::with_status(const std::string& status) const {
  return static_cast<int>(
      std::ranges::count_if(rows, [&](const CaseRow& row) { return row.findings && row.findings->status == status; }));
}

int CaseStudy::missing() const {
  return static_cast<int>(std::ranges::count_if(rows, [](const CaseRow& row) { return !row.findings; }));
}

CaseStudy evaluate_cases(const CaseFolder& folder) {
  const CasePlan& plan = folder.plan();
  CaseStudy study;
  study.columns = plan.columns;
  for (int number = 0; number < folder.count(); ++number) {
    const CasePlan::Case& one = plan.cases[static_cast<std::size_t>(number)];
    CaseRow& row = study.rows.emplace_back(CaseRow{one.name, plan.source_of(number).file.string(), one.values, {}});
    if (const auto text = folder.run_text(number)) row.findings = case_findings_from(*text, folder.run_file(number));
  }
  study.numbers = numbers_of(study.rows);
  for (const std::string& name : study.numbers)
    if (const auto statistics = statistics_of(name, study.rows)) study.statistics.push_back(*statistics);
  return study;
}

}  // namespace talus
