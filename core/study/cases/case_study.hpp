#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/cases/case_findings.hpp"
#include "study/cases/case_plan.hpp"

namespace talus {

struct CaseRow {
  std::string name;
  std::string project;                   ///< its file
  std::vector<std::string> values;       ///< a column, as JSON; empty: the project's own
  std::optional<CaseFindings> findings;  ///< none: not run yet, or it ended without a word
};

/// A number over all cases that completed and have it.
struct CaseStatistics {
  std::string name;
  int count = 0;
  double mean = 0, deviation = 0;  ///< deviation: standard, of the sample; 0 of one case
  double least = 0, p10 = 0, median = 0, p90 = 0, greatest = 0;
};

/// What the cases of a study say together.
struct CaseStudy {
  std::vector<std::string> columns;  ///< places that the table changes
  std::vector<std::string> numbers;  ///< that any case has, in order
  std::vector<CaseRow> rows;
  std::vector<CaseStatistics> statistics;  ///< a number that some completed case has

  int with_status(const std::string& status) const;
  int missing() const;
};

/// Of the cases that have ended so far. Throws InputError for a file that cannot be understood.
CaseStudy evaluate_cases(const CaseFolder& study);

/// The value below which a part of sorted values lies, between them by linear interpolation.
double quantile(const std::vector<double>& sorted, double part);

/// A row a case: case, project, status, the columns, the numbers, reason.
std::string cases_csv(const CaseStudy& study);
std::string cases_json(const CaseStudy& study);
std::string cases_markdown(const CaseStudy& study);

/// Writes cases.csv, cases.json and cases.md into the study's folder.
void write_case_files(const CaseStudy& study, const CaseFolder& folder);

}  // namespace talus
