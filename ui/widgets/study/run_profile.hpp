#pragma once

#include "study/accuracy/study_run.hpp"
#include "widgets/kit/plain_table.hpp"

namespace talus {

/// Where the time of a run went: by phase of a step, then by effect, each in seconds and as share of the whole.
class RunProfile : public PlainTable {
  Q_OBJECT
 public:
  RunProfile();
  void show(const StudyRun& run);
};

}  // namespace talus
