#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/vector.hpp"
#include "model/project.hpp"
#include "results/convergence_trouble.hpp"
#include "results/motion_class.hpp"

namespace talus {

/// Wall time of the parts of a step, s.
struct Phases {
  double detect = 0, assemble = 0, factor = 0, solve = 0, update = 0, write = 0;

  void archive(auto& state) { state(detect, assemble, factor, solve, update, write); }
};

/// Energies in J: stored in effects, dissipated, and lost to time integration. Their sum, less the work of constraints,
/// is the energy that the run began with, up to the remainder, which residual forces and round-off leave.
/// `integration_loss` is summed up effect by effect: the work of its force over a step, less what it stores and
/// dissipates. Of that `integration_reserve` comes back (solve/dynamics/integration_reserve); files leave it out.
struct EnergyLedger {
  double kinetic = 0, elastic = 0, potential = 0, contact = 0;
  double friction_dissipated = 0, damping_dissipated = 0, constraint_work = 0, integration_loss = 0;
  double remainder = 0;
  double integration_reserve = 0;  ///< beyond what the accelerations have brought with which stages began

  void archive(auto& state) {
    state(kinetic, elastic, potential, contact, friction_dissipated, damping_dissipated, constraint_work);
    state(integration_loss, remainder, integration_reserve);
  }
};

/// A row of steps.csv.
struct StepReport {
  int step = 0;
  int stage = 0;
  double time = 0, time_step = 0;                   ///< s, at the end of the step and its length
  int iterations = 0;                               ///< open–close iterations, of all attempts
  int cuts = 0;                                     ///< how often the step was cut before it converged
  int contacts = 0, open = 0, stick = 0, slip = 0;  ///< of blocks that are awake
  int asleep = 0;                                   ///< blocks that sleep at the end of the step
  double max_penetration = 0;                       ///< m
  double max_relative_penetration = 0;              ///< of the local mesh size
  double max_displacement = 0;                      ///< m, of a node in this step
  double unbalanced_force = 0;                      ///< N, norm of the residual at the end of the step
  double time_error = 0;                            ///< m, estimated error of time integration in this step
  double out_of_balance = 0;                        ///< of static steps: what inertia bears, over the largest force
  bool equilibrium = false;                         ///< a static stage ended because nothing moves any more
  Phases phases;
  EnergyLedger energy;

  void archive(auto& state) {
    state(step, stage, time, time_step, iterations, cuts, contacts, open, stick, slip, asleep, max_penetration);
    state(max_relative_penetration, max_displacement, unbalanced_force, time_error, out_of_balance, equilibrium);
    state(phases, energy);
  }
};

/// One monitor at one moment.
struct MonitorSample {
  Vec3 displacement, velocity;    ///< m, m/s
  std::optional<Voigt> stress{};  ///< Pa, Cauchy's, tension positive; where the monitor asks for it
};

/// A row of history.csv.
struct HistoryRow {
  double time = 0;
  int stage = 0;
  std::vector<MonitorSample> monitors;  ///< in Project::monitors' order
};

/// Something worth a mark on the timeline: "J5 opened", "B3 lost contact".
struct Event {
  double time = 0;
  std::string what;

  void archive(auto& state) { state(time, what); }
};

/// `interpenetrating`: blocks came to lie in each other, and what follows would be no motion of theirs.
enum class RunStatus { completed, stopped, not_converged, interpenetrating };

/// The reason of a run that was stopped on purpose.
inline constexpr const char* stopped_by_user = "stopped by the user";

/// The word summary.json uses.
constexpr std::string_view to_string(RunStatus status) {
  switch (status) {
    case RunStatus::completed:
      return "completed";
    case RunStatus::stopped:
      return "stopped";
    case RunStatus::not_converged:
      return "not-converged";
    case RunStatus::interpenetrating:
      break;
  }
  return "interpenetrating";
}

struct BlockOutcome {
  std::string name;
  BodyKind body = BodyKind::tetrahedra;
  std::string body_reason{};  ///< why it was chosen; empty where the project says the body
  double volume = 0, relative_volume_change = 0;
  Vec3 displacement = Vec3::Zero();  ///< m, of the centroid
  double rotation_degrees = 0;
  Vec3 velocity = Vec3::Zero();  ///< m/s, of the centroid
  MotionClass motion;
};

/// An effect of the run; what is off was built and evaluated zero times.
struct EffectOutcome {
  std::string name;
  bool active = false;
  std::string reason;
  double seconds = 0;    ///< wall time
  long built = 0;        ///< how often it was constructed: once a stage that calls for it
  long evaluations = 0;  ///< of its forces
  long assemblies = 0;   ///< of its stiffness
};

/// What a run has done, in counts: the same on every machine.
struct RunWork {
  long body_pairs = 0;            ///< distances of two blocks that were measured
  long facet_searches = 0;        ///< pairs of blocks whose facets were searched
  long facet_pairs = 0;           ///< pairs of facets looked at, step by step
  long contact_points = 0;        ///< handed to the effects, step by step
  long factorisations = 0;        ///< sparse ones …
  long dense_factorisations = 0;  ///< … and those of small systems
  long linear_solves = 0;         ///< of one independent system each
  long gmres_iterations = 0;
  /// Independent ones at the end, and the degree-of-freedom blocks of the largest, each of three unknowns.
  int systems = 0, largest_system = 0;
  long block_steps_asleep = 0;  ///< steps that blocks slept through, in all
  long wakings = 0;             ///< blocks that something woke by touching it
  long stress_recoveries = 0;   ///< blocks' stresses that were computed, for frames and monitors
  // Limits that were reached, after which the run went on with what there was:
  long correction_limits = 0;      ///< steps that used all their rounds of correction
  long impact_sweep_limits = 0;    ///< steps that used all their sweeps of impulses
  long gmres_limits = 0;           ///< linear solves that used all their iterations
  long failed_factorisations = 0;  ///< interior-point attempts without an LU factor: singular, or not enough memory
};

struct ExpectationOutcome {
  Expectation expectation;
  double computed = 0, error = 0;  ///< error in the tolerance's sense: relative, or absolute where the value is zero
  bool reached = false;            ///< false: the run ended before `time`
  bool passed = false;
};

/// summary.json.
struct RunReport {
  std::string version;   ///< of the program
  std::string finished;  ///< when, in UTC, as ISO 8601 has it: "2026-03-01T17:04:00Z"
  RunStatus status = RunStatus::completed;
  std::string
      reason;  ///< why it stopped, did not converge or lies in itself: contact, place, joint; empty when completed
  double time = 0, wall_seconds = 0;
  int steps = 0, threads = 1, frames = 0;
  double tolerance = SolverSettings{}.tolerance;  ///< that steps were solved to
  std::vector<BlockOutcome> blocks;
  MotionNames names;  ///< for the blocks' motions
  StepReport last_step;
  double max_penetration = 0, max_relative_penetration = 0;  ///< over the whole run
  long iterations = 0, cuts = 0;
  Phases phases;
  std::vector<EffectOutcome> effects;
  RunWork work;
  std::vector<ConvergenceTrouble> troubles;  ///< the hardest places, the hardest first
  std::vector<Event> events;
  std::vector<ExpectationOutcome> expect;
};

/// Expected values that did not come out, or were not reached.
inline long missed_expectations(const RunReport& report) {
  return std::count_if(report.expect.begin(), report.expect.end(),
                       [](const ExpectationOutcome& outcome) { return !outcome.passed; });
}

}  // namespace talus
