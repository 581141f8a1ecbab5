#include "study/forecast.hpp"

#include <malloc.h>

#include <algorithm>
#include <cmath>

#include "bodies/block_motion.hpp"
#include "solve/simulation.hpp"
#include "solve/stopwatch.hpp"

namespace talus {

namespace {

constexpr int pieces = 20;        ///< of a long stage
constexpr int timed_steps = 4;    ///< in each, the first of which only settles in
constexpr double leap = 20;       ///< most steps in one
constexpr double leaps = 100;     ///< in a stage, where that makes them no longer than `leap`
constexpr double worthwhile = 3;  ///< steps in a leap below which a stage is gone through as it is
constexpr int settling = 50;      ///< steps in which blocks of a static stage come to rest; as many tell of the others
constexpr int static_leaps = 5;   ///< through those

/// Stages of the pilot, and what they stand for.
struct Part {
  Stage stage;
  double steps = 0;   ///< of the run
  bool timed = true;  ///< else a leap
  bool sampled = false;
};

double length_of(const Stage& stage) { return stage.steps ? *stage.steps * stage.time_step : *stage.duration; }

/// The same stage without what happens at its beginning.
Stage continued(Stage stage) {
  stage.joints.clear();
  stage.loads.reset();
  stage.constraints.reset();
  stage.blocks.clear();
  return stage;
}

/// So many steps of the same stage, of `length` [s] together.
Stage in_steps(Stage stage, int steps, double length) {
  stage.duration.reset();
  stage.steps = steps;
  stage.time_step = length / steps;
  return stage;
}

/// Steps of the run in a leap of a dynamic stage.
double steps_in_a_leap(const Stage& whole) { return std::min(leap, length_of(whole) / whole.time_step / leaps); }

void add_static(const Stage& whole, std::vector<Part>& parts) {
  const double steps = length_of(whole) / whole.time_step, timed = settling * whole.time_step;
  parts.push_back({in_steps(whole, settling, timed), settling});
  parts.push_back({in_steps(continued(whole), settling, timed), steps - settling, true, true});
  parts.push_back({in_steps(continued(whole), static_leaps, length_of(whole) - 2 * timed), 0, false, true});
}

/// `shorter`: by how much leaps are shorter than they could be.
void add_dynamic(const Stage& whole, double shorter, std::vector<Part>& parts) {
  const double length = length_of(whole) / pieces, timed = timed_steps * whole.time_step;
  const int count =
      static_cast<int>(std::ceil(shorter * (length - timed) / (steps_in_a_leap(whole) * whole.time_step)));
  for (int k = 0; k < pieces; ++k) {
    parts.push_back(
        {in_steps(k == 0 ? whole : continued(whole), timed_steps, timed), length / whole.time_step, true, true});
    parts.push_back({in_steps(continued(whole), count, length - timed), 0, false, true});
  }
}

std::vector<Part> parts_of(const Project& project, double shorter) {
  std::vector<Part> parts;
  const bool adaptive = project.solver.time_step_control == TimeStepControl::adaptive;
  for (const Stage& whole : project.stages) {
    const double steps = length_of(whole) / whole.time_step;
    if (!adaptive && whole.kind == StageKind::static_ && !whole.until_equilibrium && steps > 4 * settling)
      add_static(whole, parts);
    else if (!adaptive && whole.kind == StageKind::dynamic && steps_in_a_leap(whole) >= worthwhile)
      add_dynamic(whole, shorter, parts);
    else
      parts.push_back({whole, steps});
  }
  return parts;
}

Project with_stages(Project project, const std::vector<Part>& parts) {
  project.stages.clear();
  for (const Part& part : parts) project.stages.push_back(part.stage);
  return project;
}

/// Bytes that the program has asked for and not given back. (What the system holds for it also counts what was freed.)
double memory_held() {
  const auto held = mallinfo2();
  return static_cast<double>(held.uordblks + held.hblkhd);
}

/// One way through the pilot's stages.
class Pilot {
 public:
  Pilot(const Project& project, const BlockSystem& system, double shorter)
      : parts_(parts_of(project, shorter)), project_(with_stages(project, parts_)), simulation_(project_, system) {}

  /// False where the budget ended it, or the run did not converge.
  bool run(double budget, Progress& progress) {
    std::vector<double> seconds(parts_.size(), 0), counted(parts_.size(), 0), taken(parts_.size(), 0);
    double spent = 0;
    while (!simulation_.finished() && spent < budget) {
      if (progress.cancelled()) throw Cancelled{};
      double now = 0;
      int stage = 0;
      {
        const Stopwatch watch(now);
        stage = simulation_.step().stage;
      }
      spent += now;
      if (++taken[stage] > 1 || !parts_[stage].sampled) {
        seconds[stage] += now;
        ++counted[stage];
      }
      progress.report(std::max(spent / budget, simulation_.time() / simulation_.end_time()), {});
    }
    add_up(seconds, counted, taken);
    return simulation_.converged() && simulation_.finished();
  }

  double seconds() const { return seconds_; }
  double share_seen() const { return simulation_.time() / simulation_.end_time(); }
  const Simulation& simulation() const { return simulation_; }

 private:
  void add_up(const std::vector<double>& seconds, const std::vector<double>& counted,
              const std::vector<double>& taken) {
    double a_step = 0;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      if (counted[i] > 0 && parts_[i].timed) a_step = seconds[i] / counted[i];
      const bool ended = !parts_[i].sampled && static_cast<int>(i) < simulation_.stage();
      seconds_ += a_step * (ended ? taken[i] : parts_[i].steps);
    }
  }

  std::vector<Part> parts_;
  Project project_;
  Simulation simulation_;
  double seconds_ = 0;
};

/// Largest difference of the ways of blocks, over the largest way; empty where nothing moves.
std::optional<double> difference(const Simulation& a, const Simulation& b) {
  double largest = 0, apart = 0;
  for (std::size_t i = 0; i < a.bodies().bodies.size(); ++i) {
    const Vec3 mine = block_motion(a.bodies(), static_cast<int>(i)).displacement;
    largest = std::max(largest, mine.norm());
    apart = std::max(apart, (mine - block_motion(b.bodies(), static_cast<int>(i)).displacement).norm());
  }
  if (largest == 0) return std::nullopt;
  return apart / largest;
}

/// Steps of the run in a leap of the stage with the longest ones, 0 where there are none.
double longest_leap(const Project& project) {
  double longest = 0;
  for (const Stage& stage : project.stages)
    if (stage.kind == StageKind::dynamic && project.solver.time_step_control == TimeStepControl::fixed &&
        steps_in_a_leap(stage) >= worthwhile)
      longest = std::max(longest, steps_in_a_leap(stage));
  return longest;
}

void look_ahead(const Project& project, const BlockSystem& system, double budget, Progress& progress,
                Forecast& result) {
  for (const Stage& stage : project.stages) result.steps += std::lround(std::ceil(length_of(stage) / stage.time_step));
  const double before = memory_held();
  Pilot pilot(project, system, 1);
  const bool came_through = pilot.run(budget, progress);
  result.seconds = pilot.seconds();
  result.share_seen = pilot.share_seen();
  result.memory = std::max(0.0, memory_held() - before);
  const double in_a_leap = longest_leap(project);
  if (!came_through || in_a_leap == 0) return;
  Pilot finer(project, system, 2);
  if (!finer.run(budget, progress)) return;
  if (const auto apart = difference(pilot.simulation(), finer.simulation())) result.error = *apart * 2 / in_a_leap;
}

}  // namespace

Project pilot_of(const Project& project) { return with_stages(project, parts_of(project, 1)); }

Forecast forecast(const Project& project, const BlockSystem& system, double budget, Progress& progress) {
  Forecast result;
  double seconds = 0;
  {
    const Stopwatch watch(seconds);
    look_ahead(project, system, budget, progress, result);
  }
  result.pilot_seconds = seconds;
  return result;
}

}  // namespace talus
