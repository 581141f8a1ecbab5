#include <chrono>
#include <cstdio>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "command.hpp"
#include "io/project_change.hpp"
#include "model/number_text.hpp"
#include "options.hpp"
#include "project_choice.hpp"
#include "results/checkpoint.hpp"
#include "results/folder.hpp"
#include "results/summary.hpp"
#include "run/run.hpp"
#include "run/run_estimate.hpp"
#include "text/effect_text.hpp"
#include "text/json_text.hpp"
#include "text/report_text.hpp"
#include "text/terminal.hpp"

namespace talus::cli {

namespace {

struct SolveOptions {
  ProjectChoice project;
  std::filesystem::path out;
  int threads = 1;
  bool resume = false;
  double checkpoint_every = RunOptions{}.checkpoint_every;  ///< s
  std::optional<double> max_wall;                           ///< s
};

double duration(const Project& project) {
  double seconds = 0;
  for (const Stage& stage : project.stages)
    seconds += stage.steps ? *stage.steps * stage.time_step : stage.duration.value_or(0);
  return seconds;
}

using Clock = std::chrono::steady_clock;

/// When a run that begins now has used its time.
Clock::time_point deadline_of(const std::optional<double>& max_wall) {
  if (!max_wall) return Clock::time_point::max();
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(*max_wall));
}

/// Shows how far the run is, and ends it after the step on Ctrl-C or when its time is up.
class Watch final : public RunObserver {
 public:
  Watch(const Project& project, Clock::time_point deadline)
      : project_(project), end_(duration(project)), deadline_(deadline) {}

  void on_step(const StepReport& step, const HistoryRow&, double fraction) override {
    ++steps_;
    iterations_ += step.iterations;
    char text[80];
    std::snprintf(text, sizeof text, "%.2f of %.2f s, %.1f iterations a step, ", step.time, end_,
                  static_cast<double>(iterations_) / static_cast<double>(steps_));
    progress_.report(fraction, text + project_.stages[static_cast<std::size_t>(step.stage)].name);
  }
  void on_frame(std::shared_ptr<const Frame>) override {}
  bool go_on() override { return !interrupted() && Clock::now() < deadline_; }

 private:
  const Project& project_;
  const double end_;
  const Clock::time_point deadline_;
  long steps_ = 0, iterations_ = 0;
  TerminalProgress progress_;
};

/// NAME.results beside NAME.talus. Throws InputError for standard input, which has no name.
std::filesystem::path results_folder(const SolveOptions& options) {
  if (!options.out.empty()) return options.out;
  if (options.project.is_standard_input())
    throw InputError("--out", "standard input has no name that a results folder could have", "give one with --out");
  return std::filesystem::path(options.project.file).replace_extension(".results");
}

/// Whether the run that the results folder holds can go on as the project, which is `text` now. Throws InputError where
/// it cannot.
void check_resumable(const SolveOptions& options, const std::string& text) {
  const auto last = read_checkpoint_label(results_folder(options) / "checkpoint.h5");
  if (!last) {
    std::cerr << "No checkpoint in " << results_folder(options).string() << ": the run begins at the start\n";
    return;
  }
  if (const auto change = change_since_run(last->project_text, text))
    throw InputError(options.project.name() + ": " + *change, "is not what it was when the run began",
                     "take the change back, or run without --resume; only stages may last longer or follow");
  std::cerr << "Goes on at t = " << number_text(last->time) << " s\n";
}

/// The project is read and meshed before the results folder is touched: a faulty one leaves nothing behind.
RunReport solve(const SolveOptions& options) {
  const Clock::time_point deadline = deadline_of(options.max_wall);  // cutting and meshing count
  const std::filesystem::path results = results_folder(options);
  const std::string text = text_of(options.project);
  const Project project = read(options.project, text);
  std::optional<FolderLock> nobody_else;  // begins with what is there while blocks are cut
  if (options.resume) check_resumable(options, text);
  if (options.resume && std::filesystem::exists(results)) nobody_else.emplace(results);
  catch_interrupts();
  const BlockSystem system = build(project, options.project);
  about(options.project.name(), [&] { require_room(run_estimate(project, system), results); });
  std::cerr << switched_effects_text(project);
  Watch watch(project, deadline);
  nobody_else.reset();
  return about(options.project.name(), [&] {
    return run(project, system, {results, text, options.threads, options.resume, options.checkpoint_every}, watch);
  });
}

bool all_met(const RunReport& report) {
  return report.status == RunStatus::completed && missed_expectations(report) == 0;
}

ExitCode solve_and_tell(const SolveOptions& options, bool json) {
  const RunReport report = solve(options);
  if (json) {
    auto summary = nlohmann::ordered_json::parse(summary_json(report));
    summary["results"] = results_folder(options).string();
    std::cout << json_text(summary) << '\n';
  } else {
    std::cout << report_text(report) << "Results in " << results_folder(options).string() << '\n';
  }
  return all_met(report) ? done : failed;
}

}  // namespace

void add_solve(CLI::App& program, Invocation& invocation) {
  auto* command = program.add_subcommand("solve", "Cut, mesh and compute a project; Ctrl-C stops it after the step");
  auto options = std::make_shared<SolveOptions>();
  add_project(*command, options->project);
  command->add_option("--out", options->out, "Results folder (default: NAME.results beside the project NAME.talus)")
      ->type_name("DIR");
  command->add_flag("--resume", options->resume,
                    "Go on from the last checkpoint in the results folder, to the same numbers as an undisturbed run; "
                    "from the start where there is none");
  command
      ->add_option("--checkpoint-every", options->checkpoint_every,
                   "Seconds of computing between checkpoints; each stage has one before its end (60)")
      ->type_name("S")
      ->check(CLI::PositiveNumber);
  command
      ->add_option("--max-wall", options->max_wall,
                   "Seconds after which the run is stopped as by Ctrl-C, at the end of its step (default: none)")
      ->type_name("S")
      ->check(CLI::Range(0.0, 1e9));
  add_threads(*command, options->threads);
  command->callback([&invocation, options] {
    invocation.run = [&invocation, options] { return solve_and_tell(*options, invocation.json); };
  });
}

}  // namespace talus::cli
