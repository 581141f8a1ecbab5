#include "project_run.hpp"

#include <chrono>
#include <cstdio>
#include <iostream>
#include <memory>

#include "base/error.hpp"
#include "command.hpp"
#include "io/project_change.hpp"
#include "model/number_text.hpp"
#include "results/checkpoint.hpp"
#include "results/folder.hpp"
#include "run/run_estimate.hpp"
#include "text/effect_text.hpp"
#include "text/terminal.hpp"

namespace talus::cli {

namespace {

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

/// Whether the run that the results folder holds can go on as the project, which is `text` now. Throws InputError where
/// it cannot.
void check_resumable(const ProjectChoice& project, const std::string& text, const std::filesystem::path& results) {
  const auto last = read_checkpoint_label(results / "checkpoint.h5");
  if (!last) {
    std::cerr << "No checkpoint in " << results.string() << ": the run begins at the start\n";
    return;
  }
  if (const auto change = change_since_run(last->project_text, text))
    throw InputError(project.name() + ": " + *change, "is not what it was when the run began",
                     "take the change back, or run without --resume; only stages may last longer or follow");
  std::cerr << "Goes on at t = " << number_text(last->time) << " s\n";
}

}  // namespace

std::filesystem::path results_folder(const ProjectChoice& project, const std::filesystem::path& given,
                                     const std::string& option) {
  if (!given.empty()) return given;
  if (project.is_standard_input())
    throw InputError(option, "standard input has no name that a results folder could have", "give one with " + option);
  return std::filesystem::path(project.file).replace_extension(".results");
}

RunReport solve_project(const ProjectChoice& choice, const std::string& text, const RunChoice& how) {
  const Clock::time_point deadline = deadline_of(how.max_wall);  // cutting and meshing count
  const Project project = read(choice, text);
  std::optional<FolderLock> nobody_else;  // begins with what is there while blocks are cut
  if (how.resume) check_resumable(choice, text, how.out);
  if (how.resume && std::filesystem::exists(how.out)) nobody_else.emplace(how.out);
  catch_interrupts();
  const BlockSystem system = build(project, choice);
  about(choice.name(), [&] { require_room(run_estimate(project, system), how.out); });
  std::cerr << switched_effects_text(project);
  Watch watch(project, deadline);
  nobody_else.reset();
  return about(choice.name(), [&] {
    return run(project, system, {how.out, text, how.threads, how.resume, how.checkpoint_every}, watch);
  });
}

bool all_met(const RunReport& report) {
  return report.status == RunStatus::completed && missed_expectations(report) == 0;
}

}  // namespace talus::cli
