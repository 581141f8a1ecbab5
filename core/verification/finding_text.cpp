#include "verification/finding_text.hpp"

#include <cmath>

#include "model/number_text.hpp"

namespace talus {

namespace {

std::string finite(double value, int digits) { return std::isfinite(value) ? significant(value, digits) : "–"; }

}  // namespace

FindingWords words_of(const Finding& finding) {
  const std::string sign = finding.absolute ? "±" : "";
  FindingWords words{finite(finding.expected, 7), finite(finding.computed, 7), finite(finding.error(), 2), "", ""};
  if (std::isfinite(finding.error())) words.error = sign + words.error;
  words.tolerance = finding.reported ? "–" : sign + significant(finding.tolerance, 2);
  words.verdict = finding.reported ? "shown" : finding.passed() ? "yes" : "NO";
  return words;
}

std::string repetition_text(const Repetition& repetition) {
  const std::string which = std::to_string(repetition.options.threads) +
                            (repetition.options.threads == 1 ? " thread" : " threads") + ", scale " +
                            significant(repetition.options.scale, 6) + ": ";
  if (!repetition.failure.empty()) return which + "failed: " + repetition.failure;
  if (repetition.same_bits) return which + "the same bits";
  std::string text = which + (repetition.passed ? "the same; " : "NOT the same; ") + "relative difference " +
                     finite(repetition.largest.value, 2);
  if (!repetition.largest.quantity.empty()) text += " (" + repetition.largest.quantity + ')';
  if (repetition.about_zero.quantity.empty()) return text;
  return text + "; about zero " + finite(repetition.about_zero.value, 2) + " of the tolerance (" +
         repetition.about_zero.quantity + ')';
}

std::string alignment_of(const CaseTable& table) {
  std::string alignment;
  for (std::size_t i = 0; i < table.columns.size(); ++i) alignment += table.holds_words(i) ? 'l' : 'r';
  return alignment;
}

}  // namespace talus
