#include "study/runs/slurm_engine.hpp"

#include <chrono>
#include <system_error>
#include <thread>

#include "base/child_process.hpp"
#include "base/error.hpp"

namespace talus {

namespace {

using namespace std::chrono_literals;

constexpr const char* job_name = "slurm_job";  // file with the number of the array's job

/// In single quotes for a shell.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? "'\\''" : std::string(1, c);
  return result + "'";
}

ProgramOutput slurm(const std::string& program, const std::vector<std::string>& arguments,
                    const std::filesystem::path& log = "/dev/null") {
  try {
    return output_of(program, arguments, log);
  } catch (const std::system_error&) {
    throw InputError("engine slurm", "there is no " + program + " on this machine",
                     "begin the study on a machine of the cluster, or use --engine local");
  }
}

std::string without_line_ends(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  return text;
}

std::string script(const RunsFolder& study, const std::filesystem::path& program) {
  return "#!/bin/bash\n"
         "#SBATCH --job-name=talus-study\n"
         "#SBATCH --ntasks=1\n"
         "#SBATCH --cpus-per-task=1\n"
         "export OPENBLAS_NUM_THREADS=1\n"
         "exec " +
         quoted(program.string()) + " study run " + quoted(study.path().string()) + " \"$SLURM_ARRAY_TASK_ID\"\n";
}

/// The number of the job.
std::string submit(const RunsFolder& study, const SlurmOptions& options, const std::vector<int>& runs) {
  constexpr const char *script_name = "study.sbatch", *log_name = "sbatch.log";
  study.write(script_name, script(study, options.program));
  std::string array;
  for (const int run : runs) (array += array.empty() ? "" : ",") += std::to_string(run);
  std::vector<std::string> arguments{"--parsable", "--array=" + array,
                                     "--output=" + (study.path() / "runs" / "slurm-%a.log").string(),
                                     "--chdir=" + study.path().string()};
  arguments.insert(arguments.end(), options.arguments.begin(), options.arguments.end());
  arguments.push_back((study.path() / script_name).string());
  const ProgramOutput output = slurm("sbatch", arguments, study.path() / log_name);
  const std::string job = without_line_ends(output.text.substr(0, output.text.find(';')));
  if (output.exit_code != 0 || job.empty())
    throw InputError("engine slurm", "sbatch refused: " + without_line_ends(study.read(log_name)),
                     "give what it asks for with --sbatch, like --sbatch=--partition=long");
  study.write(job_name, job + "\n");
  return job;
}

/// Whether any task of the job waits or runs.
bool in_queue(const std::string& job) {
  const ProgramOutput output = slurm("squeue", {"--noheader", "--jobs=" + job, "--format=%T"});
  return output.exit_code == 0 && !output.text.empty();
}

/// Of an earlier call; empty where none goes on.
std::string job_under_way(const RunsFolder& study) {
  if (!std::filesystem::exists(study.path() / job_name)) return {};
  const std::string job = without_line_ends(study.read(job_name));
  return in_queue(job) ? job : std::string();
}

/// Until the files of all runs are there, or the job has left the queue for as long as `grace`: a file may reach this
/// machine a while after that. `all`: runs that were missing at first.
void wait_for(const RunsFolder& study, const std::string& job, std::size_t all, std::chrono::milliseconds grace,
              Progress& progress) {
  constexpr std::chrono::milliseconds between_looks = 500ms, between_questions = 3s;
  auto asked = std::chrono::steady_clock::now(), last_seen = asked;
  for (;;) {
    const std::size_t left = study.missing_runs().size();
    progress.report(
        1 - static_cast<double>(left) / static_cast<double>(all),
        "Slurm job " + job + ": " + std::to_string(all - left) + " of " + std::to_string(all) + " runs have ended");
    if (left == 0) return;
    if (progress.cancelled()) throw Cancelled{};
    const auto now = std::chrono::steady_clock::now();
    if (now - asked > between_questions) {
      asked = now;
      if (in_queue(job)) last_seen = now;
    }
    if (now - last_seen > grace) return;
    std::this_thread::sleep_for(between_looks);
  }
}

}  // namespace

void run_by_slurm(const RunsFolder& study, const SlurmOptions& options, Progress& progress) {
  const std::size_t all = study.missing_runs().size();
  std::string job = job_under_way(study);
  for (int submitted = 0; submitted < options.submissions; ++submitted) {
    const std::vector<int> missing = study.missing_runs();
    if (missing.empty()) return;
    if (job.empty()) job = submit(study, options, missing);
    wait_for(study, job, all, options.grace, progress);
    job.clear();
  }
}

}  // namespace talus
