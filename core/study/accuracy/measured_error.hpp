#pragma once

#include <optional>
#include <vector>

#include "study/accuracy/study_run.hpp"

namespace talus {

/// How far a run's answer is from the known one, and from another run's. The answer is
/// - with `expect` lines: their computed numbers, each over what is expected, and the error is the largest difference.
///   Where zero is expected a number is over the largest that is expected of its kind (displacement, velocity, stress):
///   what a block goes astray is held to how far it goes. Where that is zero too, it is over the tolerance.
/// - else: displacements of blocks and monitors at the quarters of every stage, and the error is the norm of the
///   difference over the norm of the reference's.
class ErrorMeasure {
 public:
  explicit ErrorMeasure(const Project& project);

  bool known() const { return !scales_.empty(); }
  /// From the `expect` lines; nothing where there are none, or where the run did not get that far.
  std::optional<double> from_known(const StudyRun& run) const;
  /// Relative, in the same sense; `reference` gives the norm. Nothing where one of them has no answer.
  std::optional<double> between(const StudyRun& a, const StudyRun& b, const StudyRun& reference) const;

 private:
  std::vector<double> answer_of(const StudyRun& run) const;  ///< empty: it has none

  std::vector<double> scales_, expected_;  ///< an expectation
};

}  // namespace talus
