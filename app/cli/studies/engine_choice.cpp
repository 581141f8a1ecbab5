#include "studies/engine_choice.hpp"

#include <CLI/CLI.hpp>

#include <cstdlib>
#include <filesystem>
#include <iostream>

#include "study/runs/local_engine.hpp"
#include "study/runs/slurm_engine.hpp"
#include "text/terminal.hpp"

namespace talus::cli {

namespace {

std::filesystem::path this_program() { return std::filesystem::read_symlink("/proc/self/exe"); }

void compute(const RunsFolder& study, const EngineChoice& choice) {
  // BLAS reads it when a program starts: that the runs have one thread each is said here.
  setenv("OPENBLAS_NUM_THREADS", "1", 1);
  TerminalProgress progress;
  if (choice.engine == "slurm")
    run_by_slurm(study, {.program = this_program(), .arguments = choice.sbatch}, progress);
  else
    run_locally(study, {this_program(), choice.jobs > 0 ? choice.jobs : free_cores()}, progress);
}

}  // namespace

void add_engine(CLI::App& command, EngineChoice& choice) {
  command.add_option("--engine", choice.engine, "Where runs go on: processes of this machine, or a Slurm job array")
      ->check(CLI::IsMember({"local", "slurm"}).description(""))
      ->type_name("local|slurm")
      ->capture_default_str();
  command.add_option("--jobs", choice.jobs, "Runs at a time, each on one thread (default: cores that are free)")
      ->check(CLI::Range(1, 1024).description(""))
      ->type_name("N");
  command
      .add_option("--sbatch", choice.sbatch,
                  "Another argument for sbatch, like --sbatch=--partition=long; may be "
                  "given again")
      ->allow_extra_args(false)
      ->type_name("ARG");
  command.add_flag("--restart", choice.restart, "Begin anew in a folder that holds a study");
  command.add_flag("--collect", choice.collect, "Run nothing: draw up what there is");
}

bool make_runs(const RunsFolder& study, const EngineChoice& choice) {
  if (choice.collect) return true;
  try {
    compute(study, choice);
    return true;
  } catch (const Cancelled&) {
    std::cerr << "talus-cli: stopped with " << study.missing_runs().size() << " of " << study.count() << " runs left"
              << (choice.engine == "slurm" ? ", which Slurm goes on with; the same command collects them\n"
                                           : "; the same command goes on\n");
    return false;
  }
}

bool tell_missing(const RunsFolder& study) {
  const std::size_t missing = study.missing_runs().size();
  if (missing > 0)
    std::cerr << "talus-cli: " << missing << " runs have no result yet; runs/*.log says what came up, and the same "
              << "command without --collect tries them again\n";
  return missing == 0;
}

}  // namespace talus::cli
