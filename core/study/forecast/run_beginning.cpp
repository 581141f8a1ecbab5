#include "study/forecast/run_beginning.hpp"

#include <algorithm>
#include <cmath>

#include "base/processor_time.hpp"
#include "base/resident_memory.hpp"
#include "base/temporary_folder.hpp"
#include "io/project_file.hpp"
#include "model/stage_length.hpp"
#include "run/run.hpp"

namespace talus {

namespace {

constexpr double of_first_look = 0.05;  ///< share of the budget, to see what a step costs
constexpr int least_steps = 2;        ///< the first step is unlike all others: so many are seen, whatever they cost …
constexpr int few_steps = 4;          ///< … and so many, …
constexpr double share_wanted = 0.1;  ///< … and this share of the run, unless …
constexpr double for_long_runs = 5;   ///< … so many times the budget is spent, or would …
constexpr double worth_looking = 0.1;  ///< … show less than this part of that share
constexpr double of_static = 0.5;      ///< share of the budget that all static stages may take, in …
constexpr int fewest_static_steps = 10, most_static_steps = 100;  ///< … so many steps each
constexpr int static_leaps = 2;                                   ///< through what is left of a static stage
constexpr double worthwhile = 1.5;                ///< times as many steps: a stage of fewer is gone through as it is
constexpr std::size_t fewest_to_extrapolate = 4;  ///< steps: from fewer it is not known when a stage ends

/// A stage of the beginning.
struct Part {
  Stage stage;
  int of = 0;           ///< stage of the run
  bool counts = true;   ///< its steps are the run's own
  bool is_end = false;  ///< of the run's stage, and nothing was left out
};

/// So many steps of the stage, of `length` [s] together.
Stage in_steps(Stage stage, int steps, double length) {
  stage.duration.reset();
  stage.steps = steps;
  stage.time_step = length / steps;
  return stage;
}

/// Without what happens at the beginning of the stage.
Stage continued(Stage stage) {
  stage.joints.clear();
  stage.loads.reset();
  stage.constraints.reset();
  stage.blocks.clear();
  return stage;
}

std::vector<Part> parts_of(const Project& project, int static_steps) {
  std::vector<Part> parts;
  const bool fixed = project.solver.time_step_control == TimeStepControl::fixed;
  for (int k = 0; k < static_cast<int>(project.stages.size()); ++k) {
    const Stage& whole = project.stages[k];
    const double seen = static_steps * whole.time_step;
    if (fixed && whole.kind == StageKind::static_ && !whole.until_equilibrium && length_of(whole) > worthwhile * seen) {
      parts.push_back({in_steps(whole, static_steps, seen), k});
      parts.push_back({in_steps(continued(whole), static_leaps, length_of(whole) - seen), k, false});
    } else {
      parts.push_back({whole, k, true, true});
    }
  }
  return parts;
}

Project with_stages(Project project, const std::vector<Part>& parts) {
  project.stages.clear();
  for (const Part& part : parts) project.stages.push_back(part.stage);
  return project;
}

/// What a look at the beginning may take.
struct Look {
  double budget = 0;  ///< s of the processor, …
  double most = 0;    ///< … and s where that lasts for a few steps only, or for less than …
  double share = 0;   ///< … this share of the model time
};

/// Times the steps until the look has taken what it may.
class StepTimer final : public RunObserver {
 public:
  StepTimer(const std::vector<Part>& parts, const Look& look, Progress& progress)
      : parts_(parts), look_(look), progress_(progress) {}

  void on_step(const StepReport& step, const HistoryRow&, double fraction) override {
    const double now = processor_seconds_of_thread(), seconds = now - since_;
    const Part& part = parts_[step.stage];
    if (part.counts) note(part, step, seconds);
    in_steps_ += seconds;
    ++steps_;
    fraction_ = fraction;
    const double enough = std::min(in_steps_ / look_.budget, look_.share > 0 ? fraction / look_.share : 1);
    progress_.report(std::min(1.0, std::max(in_steps_ / look_.most, enough)), "");
    since_ = processor_seconds_of_thread();
  }
  void on_frame(std::shared_ptr<const Frame>) override {}
  bool go_on() override {
    if (in_steps_ == 0) since_ = processor_seconds_of_thread();
    const bool saw_enough = steps_ >= few_steps && (fraction_ >= look_.share || has_no_end_in_sight());
    const bool goes_on = steps_ < least_steps || in_steps_ < (saw_enough ? look_.budget : look_.most);
    return goes_on && !progress_.cancelled();
  }

  double in_steps() const { return in_steps_; }
  std::vector<StageBeginning> take(bool completed) {
    for (const Part& part : parts_)
      if (part.is_end && part.of < static_cast<int>(stages_.size()))
        stages_[part.of].ended = completed || part.of + 1 < static_cast<int>(stages_.size());
    return std::move(stages_);
  }

 private:
  /// All that may be spent would show next to nothing of the run.
  bool has_no_end_in_sight() const { return fraction_ * look_.most < worth_looking * look_.share * in_steps_; }

  void note(const Part& part, const StepReport& step, double seconds) {
    stages_.resize(part.of + 1);
    const Phases& p = step.phases;
    const double all = p.detect + p.assemble + p.factor + p.solve + p.update + p.write;
    const double share = all > 0 ? 1 / all : 0;
    stages_[part.of].steps.push_back({step.time_step, seconds, share * p.detect,
                                      share * (p.assemble + p.factor + p.solve), step.iterations, step.out_of_balance});
  }

  const std::vector<Part>& parts_;
  const Look look_;
  Progress& progress_;
  int steps_ = 0;
  double fraction_ = 0, since_ = 0, in_steps_ = 0;
  std::vector<StageBeginning> stages_;
};

RunBeginning run_parts(const Project& project, const BlockSystem& system, int static_steps, const Look& look,
                       Progress& progress) {
  const std::vector<Part> parts = parts_of(project, static_steps);
  const Project beginning = with_stages(project, parts);
  const double begin = processor_seconds_of_thread();
  const TemporaryFolder folder;
  StepTimer timer(parts, look, progress);
  const RunReport report = run(beginning, system, {folder.path() / "results", write_project(project), 1}, timer);
  if (progress.cancelled()) throw Cancelled{};
  const bool all_counts = std::all_of(parts.begin(), parts.end(), [](const Part& part) { return part.counts; });
  RunBeginning result;
  result.around = processor_seconds_of_thread() - begin - timer.in_steps();
  result.whole = all_counts && report.status != RunStatus::stopped;
  if (result.whole) result.failure = report.reason;  // after long steps it may be theirs
  result.stages = timer.take(report.status == RunStatus::completed);
  return result;
}

double seconds_in_steps(const RunBeginning& beginning) {
  double seconds = 0;
  for (const StageBeginning& stage : beginning.stages)
    for (const TimedStep& step : stage.steps) seconds += step.seconds;
  return seconds;
}

int affordable_static_steps(const Project& project, const RunBeginning& first, double budget) {
  double steps = 0;
  for (const StageBeginning& stage : first.stages) steps += static_cast<double>(stage.steps.size());
  const auto stages = std::count_if(project.stages.begin(), project.stages.end(),
                                    [](const Stage& stage) { return stage.kind == StageKind::static_; });
  const double affordable =
      of_static * budget * steps / seconds_in_steps(first) / static_cast<double>(std::max<long>(1, stages));
  return static_cast<int>(std::clamp<double>(affordable, fewest_static_steps, most_static_steps));
}

}  // namespace

double steps_to_end(const Stage& stage, const StageBeginning& seen, double left) {
  if (!stage.until_equilibrium || seen.steps.size() < fewest_to_extrapolate) return left;
  const std::size_t last = seen.steps.size() - 1, middle = seen.steps.size() / 2;
  const double then = seen.steps[middle].out_of_balance, now = seen.steps[last].out_of_balance;
  if (!(now > 0 && now < then)) return left;
  const double a_step = std::log(then / now) / static_cast<double>(last - middle);
  return std::clamp(std::log(now / stage.equilibrium_tolerance) / a_step, 0.0, left);
}

Project beginning_of(const Project& project, int static_steps) {
  return with_stages(project, parts_of(project, static_steps));
}

RunBeginning run_beginning(const Project& project, const BlockSystem& system, double budget, Progress& progress) {
  const double begin = processor_seconds_of_thread();
  const bool counts = count_resident_memory_anew();
  const double memory_before = resident_memory().now;  // what the first look leaves behind is held by the run, too
  const double most = for_long_runs * budget;
  RunBeginning result = run_parts(project, system, most_static_steps, {of_first_look * budget, most, 0}, progress);
  if (!result.whole && seconds_in_steps(result) < most / 2) {
    const int static_steps = affordable_static_steps(project, result, budget);
    result = run_parts(project, system, static_steps, {budget, most, share_wanted}, progress);
  }
  const ResidentMemory memory = resident_memory();
  result.seconds = processor_seconds_of_thread() - begin;
  result.memory = std::max(0.0, (counts ? memory.most : memory.now) - memory_before);
  return result;
}

}  // namespace talus
