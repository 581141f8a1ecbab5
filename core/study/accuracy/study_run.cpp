#include "study/accuracy/study_run.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "base/error.hpp"
#include "base/part_of_progress.hpp"
#include "bodies/block_motion.hpp"
#include "geometry/block_builder.hpp"
#include "mesh/unknowns.hpp"
#include "model/stage_length.hpp"
#include "results/folder.hpp"
#include "run/run.hpp"
#include "study/accuracy/perturbation.hpp"
#include "study/accuracy/study_run_json.hpp"
#include "study/accuracy/travel_watch.hpp"

namespace talus {

namespace {

constexpr double meshing_share = 0.1;  // of the time that a run takes

/// s, of all threads of this process.
double processor_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Where everything is after a step.
struct Sight {
  std::vector<Vec3> displacements;
  std::vector<Voigt> stresses;
};

template <typename Vector>
std::vector<Vector> between(const std::vector<Vector>& a, const std::vector<Vector>& b, double share) {
  std::vector<Vector> values;
  for (std::size_t i = 0; i < b.size(); ++i) values.push_back(a[i] + share * (b[i] - a[i]));
  return values;
}

/// Notes where everything is at the quarters of every stage, between two steps by linear interpolation.
class Observer final : public RunObserver {
 public:
  Observer(const Project& project, const BlockSystem& system, Progress& progress)
      : project_(project), system_(system), progress_(progress), travel_(project, system) {
    before_.displacements.assign(movable_count() + project.monitors.size(), Vec3::Zero());
  }

  void on_bodies(const StepReport& step, const BodySet& bodies) override {
    travel_.look(step, bodies);
    now_ = {};
    for (std::size_t b = 0; b < system_.blocks.size(); ++b)
      if (system_.blocks[b].body != BodyKind::fixed)
        now_.displacements.push_back(block_motion(bodies, static_cast<int>(b)).displacement);
  }

  void on_step(const StepReport& step, const HistoryRow& row, double fraction) override {
    for (const MonitorSample& sample : row.monitors) {
      now_.displacements.push_back(sample.displacement);
      if (sample.stress) now_.stresses.push_back(*sample.stress);
    }
    if (before_.stresses.empty()) before_.stresses = now_.stresses;  // what there was before the first step is not told
    if (step.stage != stage_) begin(step.stage);
    const Stage& stage = project_.stages[static_cast<std::size_t>(stage_)];
    const double since = step.time - stage_begin_, duration = length_of(stage);
    const double slack = 1e-9 * duration;
    if (!stage.until_equilibrium)
      for (; quarter_ <= 4 && quarter_ * duration / 4 <= since + slack; ++quarter_)
        note(quarter_ * duration / 4, since - step.time_step, since);
    last_time_ = step.time;
    std::swap(before_, now_);
    progress_.report(fraction, "");
  }
  void on_frame(std::shared_ptr<const Frame>) override {}
  bool go_on() override { return !progress_.cancelled(); }

  void tell(StudyRun& run) {
    close_stage();
    run.moments = std::move(moments_);
    run.travel = travel_.travel();
  }

 private:
  std::size_t movable_count() const {
    return static_cast<std::size_t>(std::count_if(system_.blocks.begin(), system_.blocks.end(),
                                                  [](const Block& block) { return block.body != BodyKind::fixed; }));
  }

  void begin(int stage) {
    close_stage();
    stage_ = stage;
    stage_begin_ = last_time_;
    quarter_ = 1;
  }

  /// How long a stage took to its equilibrium differs from run to run: its end alone is one moment in all of them.
  void close_stage() {
    if (stage_ < 0) return;
    const Stage& stage = project_.stages[static_cast<std::size_t>(stage_)];
    if (stage.until_equilibrium)
      moments_.push_back({stage.name, last_time_ - stage_begin_, before_.displacements, before_.stresses});
  }

  /// `begin`, `end` [s] of the last step, since the stage began.
  void note(double moment, double begin, double end) {
    const double share = std::clamp((moment - begin) / (end - begin), 0.0, 1.0);
    moments_.push_back({project_.stages[static_cast<std::size_t>(stage_)].name, moment,
                        between(before_.displacements, now_.displacements, share),
                        between(before_.stresses, now_.stresses, share)});
  }

  const Project& project_;
  const BlockSystem& system_;
  Progress& progress_;
  int stage_ = -1, quarter_ = 1;
  double stage_begin_ = 0, last_time_ = 0;  ///< s
  Sight before_, now_;
  std::vector<StudyMoment> moments_;
  TravelWatch travel_;
};

void count(const BlockSystem& system, StudyRun& run) {
  for (const Block& block : system.blocks) {
    run.dofs += unknowns_of(block);
    if (block.body == BodyKind::fixed) continue;
    ++run.blocks;
    if (block.body == BodyKind::tetrahedra) run.tetrahedra += static_cast<long>(block.mesh.tetrahedra.size());
  }
}

void take_report(const RunReport& report, StudyRun& run) {
  if (report.status == RunStatus::not_converged) run.status = StudyStatus::not_converged;
  if (report.status == RunStatus::interpenetrating) run.status = StudyStatus::failed;
  run.reason = report.reason;
  run.wall_seconds = report.wall_seconds;
  run.steps = report.steps;
  run.iterations = report.iterations;
  run.cuts = report.cuts;
  run.expect = report.expect;
  run.phases = report.phases;
  run.effects = report.effects;
}

/// The results lie in the study as long as the run goes on: what a killed one leaves is found, and taken away when it
/// is run again.
void solve(const Project& project, const BlockSystem& system, const StudyPlan& plan,
           const std::filesystem::path& results, Progress& progress, StudyRun& outcome) {
  std::filesystem::remove_all(results);
  Observer observer(project, system, progress);
  const double begin = processor_seconds();
  const RunReport report = run(project, system, {results, text_of(project, plan), 1}, observer);
  outcome.cpu_seconds = processor_seconds() - begin;
  std::filesystem::remove_all(results);
  if (progress.cancelled()) throw Cancelled{};
  if (report.status == RunStatus::stopped) throw WriteError(results, report.reason);
  take_report(report, outcome);
  observer.tell(outcome);
}

}  // namespace

void perform_study_run(const StudyFolder& study, int number, Progress& progress) {
  const StudyPlan& plan = study.plan();
  PartOfProgress meshing(progress, 0, meshing_share, ""), solving(progress, meshing_share, 1 - meshing_share, "");
  StudyRun outcome;
  try {
    const Project project = perturbed(under(plan.setting_of(number), project_of(plan)), plan.repeat_of(number));
    const double begin = wall_seconds();
    const BlockSystem system = build_blocks(project, plan.project_file.parent_path(), meshing);
    outcome.mesh_seconds = wall_seconds() - begin;
    count(system, outcome);
    solve(project, system, plan, study.results_folder(number), solving, outcome);
  } catch (const WriteError&) {  // no fault of the setting: the run is missing
    throw;
  } catch (const InputError& error) {
    outcome.status = StudyStatus::failed;
    outcome.reason = error.what();
  }
  study.write_run(number, study_run_text(outcome));
}

}  // namespace talus
