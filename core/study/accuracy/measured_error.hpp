#pragma once

#include <optional>
#include <vector>

#include "study/accuracy/study_run.hpp"

namespace talus {

/// What the runs of one setting answer, number by number.
struct StudyAnswer {
  std::vector<double> mean;
  std::vector<double> deviation;  ///< standard deviation of one run about it; zeros of a single run
  int runs = 1;
};

/// How far a setting's answer is from the known one, and from another setting's. The answer is
/// - with `expect` lines, and no other wish: their computed numbers, each over what is expected, and the error is the
///   largest difference. Where zero is expected a number is over the largest that is expected of its kind
///   (displacement, velocity, stress): what a block goes astray is held to how far it goes. Where that is zero too, it
///   is over the tolerance.
/// - else: what is to be measured, displacements where nothing is said, and the error is the norm of the difference
/// over
///   the norm of the reference's.
class ErrorMeasure {
 public:
  explicit ErrorMeasure(const Project& project, std::optional<StudyMeasure> measure = {});

  bool known() const { return !scales_.empty(); }
  /// The mean of the runs; nothing where one of them has no answer, or there is none.
  std::optional<StudyAnswer> mean_answer(const std::vector<StudyRun>& repeats) const;
  /// From the `expect` lines; nothing where there are none, or where the runs did not get that far.
  std::optional<double> from_known(const StudyAnswer& answer) const;
  /// Relative, in the same sense; `reference` gives the norm. Nothing where they answer unlike questions.
  std::optional<double> between(const StudyAnswer& a, const StudyAnswer& b, const StudyAnswer& reference) const;
  /// How far one run scatters about the mean: its standard deviation, in the same sense.
  double spread(const StudyAnswer& answer, const StudyAnswer& reference) const;

 private:
  std::vector<double> numbers_of(const StudyRun& run) const;  ///< empty: it has none

  StudyMeasure measure_;
  std::vector<double> scales_, expected_;  ///< an expectation
};

}  // namespace talus
