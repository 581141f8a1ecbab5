#include "run/recording.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <stdexcept>

#include "base/error.hpp"
#include "base/state_archive.hpp"
#include "base/stopwatch.hpp"
#include "base/units.hpp"
#include "mesh/digest.hpp"
#include "model/number_text.hpp"

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

std::string utc_now() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

std::string describe(const StepReport& step) {
  char line[160];
  std::snprintf(line, sizeof line, "t = %.6g s: step %d, %d iterations, %d cuts, residual %.3g N", step.time, step.step,
                step.iterations, step.cuts, step.unbalanced_force);
  return line;
}

/// Which program wrote a state: only the same reads it. The second number is to be raised when a list in some
/// `archive` changes.
constexpr const char* version = TALUS_VERSION ", state 8";

/// Checkpoints take no more than this part of a run's time.
constexpr double share_of_checkpoints = 0.02;

}  // namespace

Recording::Recording(const Project& project, const BlockSystem& system, const RunOptions& options,
                     Simulation& simulation, RunObserver& observer)
    : project_(project),
      system_(system),
      options_(options),
      simulation_(simulation),
      observer_(observer),
      events_(system),
      motions_(project, system, simulation.bodies()),
      expectations_(project, system),
      interpenetration_(system, simulation),
      next_frame_(project.output.every),
      next_checkpoint_(options.checkpoint_every) {
  simulation_.watch_iterations([this](double unbalanced) { observer_.on_iteration(unbalanced); });
  report_.threads = options.threads;
  report_.tolerance = project.solver.tolerance;
}

void Recording::begin() {
  writer_.emplace(options_.out, project_, system_, options_.project_text);
  const HistoryRow row = simulation_.history();
  expectations_.look(simulation_, row);
  writer_->add_history(row);
  write_frame();
}

void Recording::archive(StateArchive& state) {
  state(events_, motions_, stage_events_, troubles_, expectations_, next_frame_);
  state(report_.steps, report_.frames, report_.iterations, report_.cuts, report_.max_penetration);
  state(report_.max_relative_penetration, report_.phases, report_.last_step, report_.wall_seconds);
}

void Recording::keep_checkpoint() {
  double seconds = 0;
  {
    const Stopwatch watch(seconds);
    WrittenResults written = writer_->written();
    std::uint64_t blocks = digest(system_);
    const CheckpointLabel label{version, options_.project_text, simulation_.time()};
    write_checkpoint(options_.out / "checkpoint.h5", label, [&](const StateArchive::Sink& sink) {
      StateArchive state(sink);
      state(blocks, written);
      simulation_.archive(state);
      archive(state);
      state.pass_on();
    });
  }
  report_.phases.write += seconds;
  report_.wall_seconds += seconds;
  next_checkpoint_ = report_.wall_seconds + std::max(options_.checkpoint_every, seconds / share_of_checkpoints);
}

void Recording::resume(const Checkpoint& from) {
  const std::string place = (options_.out / "checkpoint.h5").string(), remedy = "run the project without --resume";
  if (from.label.version != version)
    throw InputError(place, "was written by another version of Talus: " + from.label.version, remedy);
  StateArchive state(from.state);
  std::uint64_t blocks = 0;
  WrittenResults written;
  try {
    state(blocks, written);
    if (blocks != digest(system_)) throw std::runtime_error("is of other blocks than the project's");
    simulation_.archive(state);
    archive(state);
  } catch (const std::exception& error) {
    throw InputError(place, error.what(), remedy);
  }
  if (!state.all_read()) throw InputError(place, "holds more than the state of the run", remedy);
  writer_.emplace(options_.out, project_, system_, options_.project_text, written);
  next_checkpoint_ = report_.wall_seconds + options_.checkpoint_every;
}

/// Before the last step of a stage, not behind it: so a run may go on where the stage lasts longer.
void Recording::take_step() {
  if (simulation_.stage_ends() || report_.wall_seconds >= next_checkpoint_) keep_checkpoint();
  const Stopwatch watch(report_.wall_seconds);
  take(simulation_.step());
}

void Recording::take(StepReport step) {
  {
    const Stopwatch watch(step.phases.write);
    const HistoryRow row = simulation_.history();
    writer_->add_history(row);
    expectations_.look(simulation_, row);
    events_.look(simulation_);
    motions_.look(simulation_.time(), simulation_.stage_ended(), simulation_.bodies(), simulation_.awake_contacts());
    const bool due = simulation_.time() >= next_frame_ - 1e-9 * step.time_step;
    if (due || simulation_.stage_ended() || simulation_.finished()) {
      write_frame();
      interpenetrating_ = interpenetration_.look(step, report_.max_relative_penetration);
      next_frame_ = project_.output.every * (std::floor(simulation_.time() / project_.output.every + 1e-9) + 1);
    } else if (last_frame_ && observer_.wants_moment()) {
      observer_.on_moment(std::make_shared<const Frame>(simulation_.moment(*last_frame_)));
    }
    observer_.on_bodies(step, simulation_.bodies());
    observer_.on_step(step, row, simulation_.time() / simulation_.end_time());
  }
  writer_->add_step(step);
  if (step.cuts > 0) writer_->log(describe(step));
  if (step.equilibrium)
    stage_events_.push_back({step.time, "stage " + project_.stages[step.stage].name + " in equilibrium"});
  add_step(report_, step);
  note_troubles();
}

RunReport Recording::finish() {
  if (interpenetrating_) {
    report_.status = RunStatus::interpenetrating;
    report_.reason = failure_text(*interpenetrating_);
    troubles_.add(*interpenetrating_);
  } else if (!simulation_.converged()) {
    report_.status = RunStatus::not_converged;
    report_.reason = simulation_.failure();
  } else if (!simulation_.finished()) {
    report_.status = RunStatus::stopped;
    report_.reason = stopped_by_user;
    keep_checkpoint();
  } else if (report_.last_step.equilibrium) {
    keep_checkpoint();
  }
  gather_report();
  writer_->finish(report_);
  return report_;
}

RunReport Recording::break_off(const WriteError& error) {
  report_.frames = writer_->frames();
  report_.status = RunStatus::stopped;
  report_.reason = error.place() + " " + error.problem() + ", at t = " + significant(simulation_.time(), 6) + " s; " +
                   counted_text(report_.frames, "frame is", "frames are") + " kept; make room and go on with --resume";
  gather_report();
  return report_;
}

void Recording::gather_report() {
  report_.version = TALUS_VERSION;
  report_.finished = utc_now();
  report_.time = simulation_.time();
  report_.blocks = block_outcomes(system_, simulation_.bodies(), motions_.classes(simulation_.bodies()));
  report_.names = motion_names(system_);
  report_.effects = simulation_.effects();
  report_.work = simulation_.work();
  report_.troubles = troubles_.hardest();
  report_.events = merged(merged(events_.events(), motions_.events()), stage_events_);
  report_.expect = expectations_.outcomes();
}

void Recording::note_troubles() {
  if (simulation_.troubles().empty()) return;
  for (const ConvergenceTrouble& trouble : simulation_.troubles()) troubles_.add(trouble);
  observer_.on_troubles(troubles_.hardest());
}

void Recording::write_frame() {
  const auto frame = std::make_shared<Frame>(simulation_.frame(report_.frames++));
  frame->motions = motions_.classes(simulation_.bodies());
  writer_->add_frame(*frame);
  last_frame_ = frame;
  observer_.on_frame(frame);
  observer_.on_effects(simulation_.effects());
}

}  // namespace talus
