#pragma once

#include <CLI/App.hpp>

#include <string>
#include <vector>

#include "study/runs/runs_folder.hpp"

namespace talus::cli {

/// Where the runs of a study go on, and which of them.
struct EngineChoice {
  std::string engine = "local";
  int jobs = 0;  ///< at a time on this machine; 0: as many as cores are free
  std::vector<std::string> sbatch;
  bool restart = false, collect = false;
};
void add_engine(CLI::App& command, EngineChoice& choice);

/// Makes the runs that are missing and says how far they are; nothing with `collect`. False where it was interrupted,
/// which is told. Throws InputError where Slurm refuses.
bool make_runs(const RunsFolder& study, const EngineChoice& choice);

/// Tells on standard error how many runs are still missing, if any: true where none is.
bool tell_missing(const RunsFolder& study);

}  // namespace talus::cli
