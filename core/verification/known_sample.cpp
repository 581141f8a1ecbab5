#include "verification/known_sample.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>
#include <string_view>

#include "base/error.hpp"
#include "base/part_of_progress.hpp"
#include "base/temporary_folder.hpp"
#include "geometry/block_builder.hpp"
#include "io/project_file.hpp"
#include "run/run.hpp"
#include "verification/known_answers/support/scene.hpp"

namespace talus {

namespace {

constexpr double meshing_share = 0.1;  // of the time that a sample takes

double step_count(const Project& project) {
  double steps = 0;
  for (const Stage& stage : project.stages)
    steps += stage.steps ? *stage.steps : std::round(stage.duration.value_or(0) / stage.time_step);
  return steps;
}

bool asks_for_stress(const Project& project) {
  return std::any_of(project.monitors.begin(), project.monitors.end(),
                     [](const Monitor& monitor) { return monitor.stress; });
}

/// Each source once.
std::string sources_of(const Project& project) {
  std::vector<std::string> sources;
  for (const Expectation& e : project.expect)
    if (!e.source.empty() && std::find(sources.begin(), sources.end(), e.source) == sources.end())
      sources.push_back(e.source);
  std::string text;
  for (const std::string& source : sources) (text += text.empty() ? "" : "; ") += source;
  return text;
}

/// Hands a run's steps on to one who waits, and keeps the history.
class Watch final : public RunObserver {
 public:
  explicit Watch(Progress& progress) : progress_(progress) {}

  void on_step(const StepReport&, const HistoryRow& row, double fraction) override {
    history.push_back(row);
    progress_.report(fraction, "");
  }
  void on_frame(std::shared_ptr<const Frame>) override {}
  bool go_on() override { return !progress_.cancelled(); }

  std::vector<HistoryRow> history;

 private:
  Progress& progress_;
};

std::vector<std::string> monitor_names(const Project& project) {
  std::vector<std::string> names;
  for (const Monitor& monitor : project.monitors) names.push_back(monitor.name);
  return names;
}

std::vector<ReferenceEvent> scaled_events(const std::filesystem::path& file, double scale) {
  std::vector<ReferenceEvent> events = read_reference_events(file);
  for (ReferenceEvent& event : events) {
    event.time *= std::sqrt(scale);
    event.reaches *= similar(event.quantity.field, scale);
  }
  return events;
}

std::string moment(const Expectation& expectation) {
  char text[64];
  std::snprintf(text, sizeof text, " at %.4g s", expectation.time);
  std::string words = text;
  if (expectation.since) {
    std::snprintf(text, sizeof text, " since %.4g s", *expectation.since);
    words += text;
  }
  return words;
}

constexpr double did_not_happen = std::numeric_limits<double>::quiet_NaN();

Finding finding_of(const ExpectationOutcome& outcome) {
  const Expectation& e = outcome.expectation;
  const auto quantity = parse_quantity(e.quantity);
  Finding finding;
  finding.quantity = e.quantity + moment(e);
  finding.unit = unit_of(quantity ? quantity->field : Quantity::Field::displacement);
  finding.expected = e.value;
  finding.computed = outcome.reached ? outcome.computed : did_not_happen;
  finding.tolerance = e.tolerance;
  finding.absolute = e.value == 0;
  return finding;
}

/// How many events, from the first on, happened one after the other.
int count_in_order(const std::vector<EventComparison>& events) {
  int count = static_cast<int>(events.size());
  while (!in_published_order({events.data(), static_cast<std::size_t>(count)})) --count;
  return count;
}

void add_events(CaseOutcome& outcome, const std::vector<EventComparison>& events) {
  Finding order{"events in the published order", "", static_cast<double>(events.size())};
  order.computed = count_in_order(events);
  outcome.findings.push_back(order);
  CaseTable criteria{"What counts as an event", {"Event", "It has happened when"}, {}};
  for (const EventComparison& comparison : events) {
    Finding time{comparison.event.what, "s", comparison.event.time, comparison.computed.value_or(did_not_happen)};
    time.reported = true;
    outcome.findings.push_back(time);
    criteria.rows.push_back({comparison.event.what, comparison.event.criterion});
  }
  outcome.tables.push_back(criteria);
  outcome.remarks.push_back("A publication's times of events are shown beside the computed ones; held is the order.");
}

CaseOutcome outcome_of(const SampleOutcome& run) {
  if (run.report.status != RunStatus::completed) throw std::runtime_error(run.report.reason);
  CaseOutcome outcome;
  for (const ExpectationOutcome& e : run.report.expect) outcome.findings.push_back(finding_of(e));
  if (!run.events.empty()) add_events(outcome, run.events);
  return outcome;
}

}  // namespace

std::vector<KnownSample> find_known_samples(const std::filesystem::path& folder) {
  if (!std::filesystem::is_directory(folder))
    throw InputError(folder.string(), "is no folder", "give the folder of the samples with --samples");
  std::vector<KnownSample> samples;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    KnownSample sample;
    sample.name = entry.path().filename().string();
    sample.project = entry.path() / (sample.name + ".talus");
    if (!std::filesystem::exists(sample.project)) continue;
    const Project project = read_project(sample.project);
    sample.title = project.name;
    sample.source = sources_of(project);
    if (std::filesystem::exists(entry.path() / "paper_events.csv")) {
      sample.events = entry.path() / "paper_events.csv";
      (sample.source += sample.source.empty() ? "" : "; ") += "published events, paper_events.csv beside the project";
    }
    sample.takes_long = step_count(project) > quick_steps;
    sample.of_any_body = sample.events.empty() && !asks_for_stress(project);
    if (!project.expect.empty() || !sample.events.empty()) samples.push_back(std::move(sample));
  }
  std::sort(samples.begin(), samples.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  return samples;
}

SampleOutcome run_sample(const KnownSample& sample, const CaseOptions& options, Progress& progress) {
  PartOfProgress meshing(progress, 0, meshing_share, ""), solving(progress, meshing_share, 1 - meshing_share, "");
  CaseScene scene;
  scene.project = read_project(sample.project);
  scene.system = build_blocks(scene.project, sample.project.parent_path(), meshing);
  const std::string text = write_project(scene.project);
  scene = as_asked(std::move(scene), options);
  const TemporaryFolder folder;
  Watch watch(solving);
  SampleOutcome outcome;
  outcome.report = run(scene.project, scene.system, {folder.path() / "results", text, options.threads}, watch);
  if (progress.cancelled()) throw Cancelled{};
  if (!sample.events.empty())
    outcome.events =
        compare_events(scaled_events(sample.events, options.scale), monitor_names(scene.project), watch.history);
  return outcome;
}

KnownCase case_of(const KnownSample& sample) {
  KnownCase known;
  known.name = sample_prefix + sample.name;
  known.title = sample.title;
  known.source = sample.source;
  known.takes_long = sample.takes_long;
  known.of_any_body = sample.of_any_body;
  known.run = [sample](const CaseOptions& options, Progress& progress) {
    return outcome_of(run_sample(sample, options, progress));
  };
  return known;
}

}  // namespace talus
