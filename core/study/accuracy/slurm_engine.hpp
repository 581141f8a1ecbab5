#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "study/accuracy/study_plan.hpp"

namespace talus {

struct SlurmOptions {
  std::filesystem::path program;       ///< talus-cli, at the same path on every machine
  std::vector<std::string> arguments;  ///< more of them for sbatch: "--partition=long"
};

/// Writes study.sbatch, a job array with one CPU a run, hands the missing runs to Slurm and waits until their files are
/// there, or no job is left. Where jobs of an earlier call still go on it waits for those. The study's folder must be
/// seen by all machines. Throws InputError where Slurm refuses or is not there, Cancelled when told to; jobs then go
/// on.
void run_by_slurm(const StudyFolder& study, const SlurmOptions& options, Progress& progress);

}  // namespace talus
