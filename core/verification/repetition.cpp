#include "verification/repetition.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace talus {

namespace {

bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

bool same_tables(const CaseTable& a, const CaseTable& b) { return a.columns == b.columns && a.rows == b.rows; }

bool same_bits(const CaseOutcome& a, const CaseOutcome& b) {
  return std::equal(a.findings.begin(), a.findings.end(), b.findings.begin(), b.findings.end(),
                    [](const Finding& x, const Finding& y) { return same_bits(x.computed, y.computed); }) &&
         std::equal(a.tables.begin(), a.tables.end(), b.tables.begin(), b.tables.end(), same_tables) &&
         a.remarks == b.remarks;
}

double difference(const Finding& a, const Finding& b) {
  const double x = a.relative(), y = b.relative();
  if (std::isnan(x) && std::isnan(y)) return 0;  // what did not happen happened neither time
  if (!std::isfinite(x - y)) return std::numeric_limits<double>::infinity();
  return std::abs(x - y) / std::max({1.0, std::abs(x), std::abs(y)});
}

/// Whether its relative number is one of tolerances.
bool is_about_zero(const Finding& finding) { return finding.expected == 0 && finding.tolerance > 0; }

}  // namespace

Repetition compared(const CaseResult& first, const CaseResult& second) {
  Repetition repetition;
  repetition.options = second.options;
  repetition.failure = second.failure;
  const auto &a = first.outcome.findings, &b = second.outcome.findings;
  if (repetition.failure.empty() && a.size() != b.size()) repetition.failure = "computed other quantities";
  if (!repetition.failure.empty()) return repetition;

  repetition.same_bits = same_bits(first.outcome, second.outcome);
  for (std::size_t i = 0; i < a.size(); ++i) {
    auto& largest = is_about_zero(a[i]) ? repetition.about_zero : repetition.largest;
    const double apart = difference(a[i], b[i]);
    if (apart > largest.value) largest = {apart, a[i].quantity};
  }
  const bool alike = repetition.largest.value <= same_at_any_scale && repetition.about_zero.value <= noise_about_zero;
  const bool same_scale = first.options.scale == second.options.scale;
  repetition.passed = same_scale ? repetition.same_bits : alike && second.outcome.passed() == first.outcome.passed();
  return repetition;
}

}  // namespace talus
