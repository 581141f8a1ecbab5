#pragma once

#include <vector>

#include "study/accuracy/study_run.hpp"

namespace talus {

/// What the repeats of one setting cost, on the mean: seconds, counts, phases and effects. Its status and reason are
/// those of the first that did not complete, the reason with its number; answers are left out. At least one run.
StudyRun mean_run(const std::vector<StudyRun>& repeats);

}  // namespace talus
