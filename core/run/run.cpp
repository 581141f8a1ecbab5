#include "run/run.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "base/units.hpp"
#include "results/result_folder.hpp"
#include "run/event_watch.hpp"
#include "run/expectation_watch.hpp"
#include "run/interpenetration_watch.hpp"
#include "run/motion_watch.hpp"
#include "solve/simulation.hpp"

namespace talus {

namespace {

void add_phases(Phases& sum, const Phases& step) {
  sum.detect += step.detect;
  sum.assemble += step.assemble;
  sum.factor += step.factor;
  sum.solve += step.solve;
  sum.update += step.update;
  sum.write += step.write;
}

void add_step(RunReport& report, const StepReport& step) {
  report.steps = step.step;
  report.iterations += step.iterations;
  report.cuts += step.cuts;
  report.max_penetration = std::max(report.max_penetration, step.max_penetration);
  report.max_relative_penetration = std::max(report.max_relative_penetration, step.max_relative_penetration);
  add_phases(report.phases, step.phases);
  report.last_step = step;
}

std::vector<BlockOutcome> block_outcomes(const BlockSystem& system, const BodySet& bodies,
                                         const std::vector<MotionClass>& motions) {
  std::vector<BlockOutcome> outcomes;
  for (std::size_t b = 0; b < system.blocks.size(); ++b) {
    const Block& block = system.blocks[b];
    const BlockMotion motion = block_motion(bodies, static_cast<int>(b));
    outcomes.push_back({block.name, block.body, block.body_reason, block.volume, motion.relative_volume_change,
                        motion.displacement, degrees(motion.rotation), motion.velocity, motions[b]});
  }
  return outcomes;
}

std::vector<Event> merged(std::vector<Event> events, const std::vector<Event>& more) {
  events.insert(events.end(), more.begin(), more.end());
  std::stable_sort(events.begin(), events.end(), [](const Event& a, const Event& b) { return a.time < b.time; });
  return events;
}

std::string describe(const StepReport& step) {
  char line[160];
  std::snprintf(line, sizeof line, "t = %.6g s: step %d, %d iterations, %d cuts, residual %.3g N", step.time, step.step,
                step.iterations, step.cuts, step.unbalanced_force);
  return line;
}

/// What a run leaves behind: frames, histories and steps as it goes, the report at its end.
class Recording {
 public:
  Recording(const Project& project, const BlockSystem& system, const RunOptions& options, const Simulation& simulation,
            RunObserver& observer)
      : project_(project),
        system_(system),
        simulation_(simulation),
        observer_(observer),
        events_(system),
        motions_(project, system, simulation.bodies()),
        expectations_(project, system),
        interpenetration_(system, simulation),
        writer_(options.out, project, system, options.project_text),
        next_frame_(project.output.every) {
    report_.threads = options.threads;
    report_.tolerance = project.solver.tolerance;
    const HistoryRow row = simulation_.history();
    expectations_.look(simulation_, row);
    writer_.add_history(row);
    write_frame();
  }

  void take(StepReport step) {
    {
      const Stopwatch watch(step.phases.write);
      const HistoryRow row = simulation_.history();
      writer_.add_history(row);
      expectations_.look(simulation_, row);
      events_.look(simulation_);
      motions_.look(simulation_.time(), simulation_.stage_ended(), simulation_.bodies(), simulation_.awake_contacts());
      const bool due = simulation_.time() >= next_frame_ - 1e-9 * step.time_step;
      if (due || simulation_.stage_ended() || simulation_.finished()) {
        write_frame();
        interpenetrating_ = interpenetration_.look(step, report_.max_relative_penetration);
        next_frame_ = project_.output.every * (std::floor(simulation_.time() / project_.output.every + 1e-9) + 1);
      }
      observer_.on_bodies(step, simulation_.bodies());
      observer_.on_step(step, row, simulation_.time() / simulation_.end_time());
    }
    writer_.add_step(step);
    if (step.cuts > 0) writer_.log(describe(step));
    if (step.equilibrium)
      stage_events_.push_back({step.time, "stage " + project_.stages[step.stage].name + " in equilibrium"});
    add_step(report_, step);
    note_troubles();
  }

  /// Whether blocks were seen to lie in each other: the run is over.
  bool interpenetrating() const { return interpenetrating_.has_value(); }

  /// `wall`: seconds spent, without pauses.
  RunReport finish(double wall) {
    if (interpenetrating_) {
      report_.status = RunStatus::interpenetrating;
      report_.reason = failure_text(*interpenetrating_);
      troubles_.add(*interpenetrating_);
    } else if (!simulation_.converged()) {
      report_.status = RunStatus::not_converged;
      report_.reason = simulation_.failure();
    } else if (!simulation_.finished()) {
      report_.status = RunStatus::stopped;
      report_.reason = "stopped by the user";
    }
    report_.time = simulation_.time();
    report_.wall_seconds = wall;
    report_.blocks = block_outcomes(system_, simulation_.bodies(), motions_.classes(simulation_.bodies()));
    report_.names = motion_names(system_);
    report_.effects = simulation_.effects();
    report_.work = simulation_.work();
    report_.troubles = troubles_.hardest();
    report_.events = merged(merged(events_.events(), motions_.events()), stage_events_);
    report_.expect = expectations_.outcomes();
    writer_.finish(report_);
    return report_;
  }

 private:
  void note_troubles() {
    if (simulation_.troubles().empty()) return;
    for (const ConvergenceTrouble& trouble : simulation_.troubles()) troubles_.add(trouble);
    observer_.on_troubles(troubles_.hardest());
  }

  void write_frame() {
    const auto frame = std::make_shared<Frame>(simulation_.frame(report_.frames++));
    frame->motions = motions_.classes(simulation_.bodies());
    writer_.add_frame(*frame);
    observer_.on_frame(frame);
    observer_.on_effects(simulation_.effects());
  }

  const Project& project_;
  const BlockSystem& system_;
  const Simulation& simulation_;
  RunObserver& observer_;
  EventWatch events_;
  MotionWatch motions_;
  std::vector<Event> stage_events_;
  TroubleList troubles_;
  ExpectationWatch expectations_;
  InterpenetrationWatch interpenetration_;
  std::optional<ConvergenceTrouble> interpenetrating_;
  ResultWriter writer_;
  double next_frame_;  ///< s
  RunReport report_;
};

}  // namespace

RunReport run(const Project& project, const BlockSystem& system, const RunOptions& options, RunObserver& observer) {
  const ThreadLimit limit(options.threads);
  Simulation simulation(project, system);
  Recording recording(project, system, options, simulation, observer);
  double wall = 0;
  while (!simulation.finished() && !recording.interpenetrating() && observer.go_on()) {
    const Stopwatch watch(wall);
    recording.take(simulation.step());
  }
  return recording.finish(wall);
}

}  // namespace talus
