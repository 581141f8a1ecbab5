#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace talus {

/// A number that a case came to, by the name that its column has.
struct CaseNumber {
  std::string name;
  double value = 0;  ///< SI, degrees
};

/// What a case came to.
struct CaseFindings {
  /// "completed", "not-converged", "interpenetrating" as in summary.json, or "failed": it could not be cut, meshed or
  /// begun.
  std::string status;
  std::string reason;  ///< why it is not completed
  std::vector<CaseNumber> numbers;

  bool completed() const { return status == "completed"; }
  std::optional<double> number(const std::string& name) const;
};

std::string case_findings_text(const CaseFindings& findings);

/// Of a run's file. Throws InputError for a text that cannot be understood.
CaseFindings case_findings_from(const std::string& text, const std::filesystem::path& file);

}  // namespace talus
