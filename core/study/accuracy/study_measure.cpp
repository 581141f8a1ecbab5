#include "study/accuracy/study_measure.hpp"

#include "base/error.hpp"

namespace talus {

std::string measure_text(StudyMeasure measure) {
  switch (measure) {
    case StudyMeasure::run_out:
      return "of the run-out";
    case StudyMeasure::deposit:
      return "of the deposit";
    case StudyMeasure::start:
      return "of when it starts";
    case StudyMeasure::end:
      return "of when it ends";
    case StudyMeasure::stress:
      return "of stresses";
    case StudyMeasure::displacement:
      break;
  }
  return "of displacements";
}

StudyMeasure study_measure_from(const std::string& word) {
  std::string known;
  for (const StudyMeasure measure : {StudyMeasure::displacement, StudyMeasure::run_out, StudyMeasure::deposit,
                                     StudyMeasure::start, StudyMeasure::end, StudyMeasure::stress}) {
    if (to_string(measure) == word) return measure;
    (known += known.empty() ? "" : ", ") += to_string(measure);
  }
  throw InputError("measure '" + word + "'", "there is none of that name", "choose among " + known);
}

}  // namespace talus
