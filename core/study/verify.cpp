#include "study/verify.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string_view>

#include "base/error.hpp"
#include "geometry/block_builder.hpp"
#include "io/project_file.hpp"
#include "solve/run.hpp"
#include "study/temporary_folder.hpp"

namespace talus {

namespace {

double step_count(const Project& project) {
  double steps = 0;
  for (const Stage& stage : project.stages)
    steps += stage.steps ? *stage.steps : std::round(stage.duration.value_or(0) / stage.time_step);
  return steps;
}

/// Hands a run's steps on to one who waits, and keeps the history.
class Watch final : public RunObserver {
 public:
  Watch(Progress& progress, std::string_view what) : progress_(progress), what_(what) {}

  void on_step(const StepReport&, const HistoryRow& row, double fraction) override {
    history.push_back(row);
    progress_.report(fraction, what_);
  }
  void on_frame(std::shared_ptr<const Frame>) override {}
  bool go_on() override { return !progress_.cancelled(); }

  std::vector<HistoryRow> history;

 private:
  Progress& progress_;
  std::string_view what_;
};

bool met(const RunReport& report) {
  return report.status == RunStatus::completed &&
         std::all_of(report.expect.begin(), report.expect.end(), [](const auto& e) { return e.passed; });
}

std::vector<std::string> monitor_names(const Project& project) {
  std::vector<std::string> names;
  for (const Monitor& monitor : project.monitors) names.push_back(monitor.name);
  return names;
}

}  // namespace

std::vector<Sample> find_samples(const std::filesystem::path& folder) {
  if (!std::filesystem::is_directory(folder))
    throw InputError(folder.string(), "is no folder", "give the folder of the samples with --samples");
  std::vector<Sample> samples;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    Sample sample{name, entry.path() / (name + ".talus"), entry.path() / "paper_events.csv"};
    if (!std::filesystem::exists(sample.project)) continue;
    const Project project = read_project(sample.project);
    if (!std::filesystem::exists(sample.events)) sample.events.clear();
    sample.takes_long = step_count(project) > quick_steps;
    if (!project.expect.empty() || !sample.events.empty()) samples.push_back(std::move(sample));
  }
  std::sort(samples.begin(), samples.end(), [](const Sample& a, const Sample& b) { return a.name < b.name; });
  return samples;
}

SampleOutcome verify(const Sample& sample, int threads, Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  const Project project = read_project(sample.project);
  const BlockSystem system = build_blocks(project, sample.project.parent_path(), progress);
  const TemporaryFolder folder;
  Watch watch(progress, sample.name);

  SampleOutcome outcome;
  outcome.name = sample.name;
  outcome.report = run(project, system, {folder.path() / "results", write_project(project), threads}, watch);
  if (progress.cancelled()) throw Cancelled{};
  outcome.passed = met(outcome.report);
  if (!sample.events.empty()) {
    outcome.events = compare_events(read_reference_events(sample.events), monitor_names(project), watch.history);
    outcome.passed = outcome.passed && in_published_order(outcome.events);
  }
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return outcome;
}

}  // namespace talus
