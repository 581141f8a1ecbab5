#pragma once

#include <filesystem>

#include "base/progress.hpp"
#include "study/runs/runs_folder.hpp"

namespace talus {

struct LocalOptions {
  std::filesystem::path program;  ///< talus-cli
  int jobs = 1;                   ///< runs at a time, each a process of its own on one thread
};

/// Cores of this machine that nothing else keeps busy, at least one.
int free_cores();

/// Starts the runs of a study that are missing, the most expensive first, and waits for them. A run that crashes is
/// missing afterwards. Throws Cancelled when told to, and ends those that go on; what has ended is kept.
void run_locally(const RunsFolder& study, const LocalOptions& options, Progress& progress);

}  // namespace talus
