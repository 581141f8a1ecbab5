#include "solve/run.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/units.hpp"
#include "results/result_folder.hpp"
#include "solve/event_watch.hpp"
#include "solve/expectation_watch.hpp"
#include "solve/simulation.hpp"
#include "solve/stopwatch.hpp"

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

std::vector<BlockOutcome> block_outcomes(const BlockSystem& system, const BodySet& bodies) {
  std::vector<BlockOutcome> outcomes;
  for (std::size_t b = 0; b < system.blocks.size(); ++b) {
    const Block& block = system.blocks[b];
    const BlockMotion motion = block_motion(bodies, static_cast<int>(b));
    outcomes.push_back({block.name, block.body, block.volume, motion.relative_volume_change, motion.displacement,
                        degrees(motion.rotation), motion.velocity});
  }
  return outcomes;
}

std::string describe(const StepReport& step) {
  char line[160];
  std::snprintf(line, sizeof line, "t = %.6g s: step %d, %d iterations, %d cuts, residual %.3g N", step.time, step.step,
                step.iterations, step.cuts, step.unbalanced_force);
  return line;
}

}  // namespace

RunReport run(const Project& project, const BlockSystem& system, const RunOptions& options, RunObserver& observer) {
  RunReport report;
  Simulation simulation(project, system);
  EventWatch events(system);
  ExpectationWatch expectations(project, system);
  ResultWriter writer(options.out, project, system, options.project_text);

  double wall = 0, next_frame = 0;
  const auto write_frame = [&] {
    const auto frame = std::make_shared<const Frame>(simulation.frame(report.frames++));
    writer.add_frame(*frame);
    observer.on_frame(frame);
  };
  {
    const Stopwatch watch(wall);
    expectations.look(simulation);
    writer.add_history(simulation.history());
    write_frame();
    next_frame = project.output.every;
    bool wanted = observer.go_on();
    while (wanted && !simulation.finished()) {
      StepReport step = simulation.step();
      {
        const Stopwatch writing(step.phases.write);
        const HistoryRow row = simulation.history();
        writer.add_history(row);
        expectations.look(simulation);
        events.look(simulation, simulation.contacts());
        const bool due = simulation.time() >= next_frame - 1e-9 * step.time_step;
        if (due || simulation.stage_ended() || simulation.finished()) {
          write_frame();
          next_frame = project.output.every * (std::floor(simulation.time() / project.output.every + 1e-9) + 1);
        }
        observer.on_step(step, row, simulation.time() / simulation.end_time());
      }
      writer.add_step(step);
      if (step.cuts > 0) writer.log(describe(step));
      add_step(report, step);
      wanted = observer.go_on();
    }
    if (!simulation.finished()) report.reason = "stopped by the user";
  }
  report.status = !simulation.converged() ? RunStatus::not_converged
                  : simulation.finished() ? RunStatus::completed
                                          : RunStatus::stopped;
  if (!simulation.converged()) report.reason = simulation.failure();
  report.time = simulation.time();
  report.wall_seconds = wall;
  report.blocks = block_outcomes(system, simulation.bodies());
  report.effects = simulation.effects();
  report.events = events.events();
  report.expect = expectations.outcomes();
  writer.finish(report);
  return report;
}

}  // namespace talus
