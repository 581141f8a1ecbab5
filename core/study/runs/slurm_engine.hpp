#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "study/runs/runs_folder.hpp"

namespace talus {

struct SlurmOptions {
  std::filesystem::path program;         ///< talus-cli, at the same path on every machine
  std::vector<std::string> arguments{};  ///< more of them for sbatch: "--partition=long"
  /// How often runs are handed over that left no file: with a node that was lost, or a limit of time.
  int submissions = 3;
  std::chrono::milliseconds grace{15000};  ///< that a file may come after its job has left the queue
};

/// Writes study.sbatch, a job array with one CPU a run, hands the missing runs to Slurm and waits until their files are
/// there, or no job is left; runs that then have none are handed over again. Where jobs of an earlier call still go on
/// it waits for those. The study's folder must be seen by all machines. Throws InputError where Slurm refuses or is not
/// there, Cancelled when told to; jobs then go on.
void run_by_slurm(const RunsFolder& study, const SlurmOptions& options, Progress& progress);

}  // namespace talus
