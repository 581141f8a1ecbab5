#include "study/cases/case_run.hpp"

#include <chrono>
#include <ctime>

#include "base/error.hpp"
#include "base/part_of_progress.hpp"
#include "geometry/block_builder.hpp"
#include "measures/run_out.hpp"
#include "model/number_text.hpp"
#include "results/folder.hpp"
#include "results/result_folder.hpp"
#include "run/run.hpp"
#include "run/run_estimate.hpp"
#include "study/cases/case_findings.hpp"

namespace talus {

namespace {

constexpr double meshing_share = 0.1;  // of the time that a case takes

/// s, of all threads of this process.
double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Tells how far the run is, and keeps where the monitors are.
class Observer final : public RunObserver {
 public:
  explicit Observer(Progress& progress) : progress_(progress) {}

  void on_step(const StepReport&, const HistoryRow& row, double fraction) override {
    monitors_ = row.monitors;
    progress_.report(fraction, "");
  }
  void on_frame(std::shared_ptr<const Frame>) override {}
  bool go_on() override { return !progress_.cancelled(); }

  const std::vector<MonitorSample>& monitors() const { return monitors_; }

 private:
  Progress& progress_;
  std::vector<MonitorSample> monitors_;  ///< after the last step
};

void count_blocks(const BlockSystem& system, CaseFindings& findings) {
  long movable = 0, tetrahedra = 0;
  double volume = 0;
  for (const Block& block : system.blocks) {
    if (block.body == BodyKind::fixed) continue;
    ++movable;
    volume += block.volume;
    if (block.body == BodyKind::tetrahedra) tetrahedra += static_cast<long>(block.mesh.tetrahedra.size());
  }
  findings.numbers.push_back({"blocks", static_cast<double>(movable)});
  findings.numbers.push_back({"volume", volume});
  findings.numbers.push_back({"tetrahedra", static_cast<double>(tetrahedra)});
}

/// How far the rock came by the last frame.
void measure_rock(const std::filesystem::path& results, CaseFindings& findings) {
  const ResultReader reader(results);
  if (reader.frame_times().empty()) return;
  const Frame last = reader.frame(static_cast<int>(reader.frame_times().size()) - 1);
  const RunOut out = run_out(reader.system(), last);
  findings.numbers.push_back({"moved_blocks", static_cast<double>(out.rock.blocks.size())});
  findings.numbers.push_back({"moved_volume", out.rock.volume});
  if (out.rock.blocks.empty()) return;
  findings.numbers.push_back({"farthest", out.in_space.length});
  findings.numbers.push_back({"front", out.front});
  findings.numbers.push_back({"travel_angle", out.crown_to_toe.angle()});
}

void take_report(const Project& project, const RunReport& report, const Observer& observer, CaseFindings& findings) {
  findings.status = to_string(report.status);
  findings.reason = report.reason;
  findings.numbers.push_back({"time", report.time});
  findings.numbers.push_back({"steps", static_cast<double>(report.steps)});
  for (std::size_t i = 0; i < observer.monitors().size(); ++i)
    findings.numbers.push_back(
        {project.monitors[i].name + ".displacement", observer.monitors()[i].displacement.norm()});
  for (const ExpectationOutcome& one : report.expect)
    if (one.reached)
      findings.numbers.push_back(
          {one.expectation.quantity + " at " + significant(one.expectation.time, 6) + " s", one.computed});
  if (!report.expect.empty())
    findings.numbers.push_back({"missed_expectations", static_cast<double>(missed_expectations(report))});
}

/// Nobody else may work on the case: a node that was thought to be lost may come back.
void check_alone(const std::filesystem::path& results) {
  if (std::filesystem::exists(results)) FolderLock{results};
}

void solve(const Project& project, const BlockSystem& system, const RunOptions& options, Progress& progress,
           CaseFindings& findings) {
  require_room(run_estimate(project, system), options.out);
  Observer observer(progress);
  const RunReport report = run(project, system, options, observer);
  if (progress.cancelled()) throw Cancelled{};
  if (report.status == RunStatus::stopped) throw WriteError(options.out, report.reason);
  take_report(project, report, observer, findings);
  measure_rock(options.out, findings);
}

CaseFindings findings_of(const CaseFolder& study, int number, Progress& progress) {
  const CasePlan& plan = study.plan();
  const std::filesystem::path results = study.results_folder(number), folder = plan.folder_of(number);
  PartOfProgress meshing(progress, 0, meshing_share, ""), solving(progress, meshing_share, 1 - meshing_share, "");
  CaseFindings findings;
  const double begin = processor_seconds(), wall_begin = wall_seconds();
  try {
    const auto [text, project] = project_of_case(plan, number);
    const BlockSystem system = build_blocks(project, folder, meshing);
    count_blocks(system, findings);
    solve(project, system, {.out = results, .project_text = text, .resume = true}, solving, findings);
  } catch (const WriteError&) {
    throw;
  } catch (const InputError& error) {
    findings.status = "failed";
    findings.reason = error.what();
  }
  findings.numbers.push_back({"cpu_seconds", processor_seconds() - begin});
  findings.numbers.push_back({"wall_seconds", wall_seconds() - wall_begin});
  return findings;
}

}  // namespace

void perform_case(const CaseFolder& study, int number, Progress& progress) {
  const std::filesystem::path results = study.results_folder(number);
  check_alone(results);
  const CaseFindings findings = findings_of(study, number, progress);
  study.write_run(number, case_findings_text(findings));
  if (!study.plan().keep_results) std::filesystem::remove_all(results);
}

}  // namespace talus
