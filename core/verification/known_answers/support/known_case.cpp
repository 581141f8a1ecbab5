#include "verification/known_answers/support/known_case.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace talus {

double Finding::error() const {
  const double difference = std::abs(computed - expected);
  return absolute || expected == 0 ? difference : difference / std::abs(expected);
}

bool Finding::passed() const { return error() <= tolerance; }

double Finding::relative() const {
  const double whole = expected != 0 ? expected : tolerance;
  return whole != 0 ? computed / whole : computed;
}

namespace {

bool is_word(const std::string& cell) {
  char* end = nullptr;
  std::strtod(cell.c_str(), &end);
  return *end != '\0' && cell != "–";
}

}  // namespace

bool CaseTable::holds_words(std::size_t column) const {
  return std::any_of(rows.begin(), rows.end(), [column](const auto& row) { return is_word(row[column]); });
}

bool CaseOutcome::passed() const {
  return !findings.empty() &&
         std::all_of(findings.begin(), findings.end(), [](const Finding& f) { return f.reported || f.passed(); });
}

KnownCase at_any_scale(KnownCase full_size) {
  full_size.run = [run = full_size.run](const CaseOptions& options, Progress& progress) {
    CaseOutcome outcome = run(options, progress);
    for (Finding& finding : outcome.findings) {
      const double factor = finding.unit == "m"                            ? options.scale
                            : finding.unit == "s" || finding.unit == "m/s" ? std::sqrt(options.scale)
                                                                           : 1;
      finding.expected *= factor;
      finding.computed *= factor;
      if (finding.absolute) finding.tolerance *= factor;
    }
    return outcome;
  };
  return full_size;
}

}  // namespace talus
