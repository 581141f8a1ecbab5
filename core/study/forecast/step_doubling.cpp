#include "study/forecast/step_doubling.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/part_of_progress.hpp"
#include "base/processor_time.hpp"
#include "model/stage_length.hpp"
#include "solve/simulation.hpp"
#include "study/accuracy/setting.hpp"

namespace talus {

namespace {

constexpr double of_run = 1 / cost_of_step_doubling;

Project in_half_steps(const Project& project) {
  Setting half = own_setting(project);
  half.time_step = 0.5;
  return under(half, project);
}

/// s since the stage began, at about its quarters, where a step of it ends; none of static stages.
std::vector<double> moments_of(const Stage& stage) {
  if (stage.kind == StageKind::static_) return {};
  const double length = length_of(stage), steps = length / stage.time_step;
  std::vector<double> moments;
  for (int quarter = 1; quarter <= 4; ++quarter)
    moments.push_back(std::min(length, std::ceil(quarter * steps / 4 - 1e-9) * stage.time_step));
  return moments;
}

/// m, of all nodes at the moments of every stage of `given`, which `project` goes through in these steps or shorter
/// ones; empty where it does not come through.
std::vector<std::vector<Vec3>> ways_of(const Project& project, const BlockSystem& system, const Project& given,
                                       double budget, Progress& progress) {
  Simulation simulation(project, system);
  const double begin = processor_seconds_of_thread(), slack = 1e-9 * simulation.end_time();
  std::vector<std::vector<Vec3>> ways;
  std::vector<double> moments;
  std::size_t next = 0;
  int stage = -1;
  double stage_began = 0;
  while (!simulation.finished()) {
    if (progress.cancelled()) throw Cancelled{};
    if (processor_seconds_of_thread() - begin > budget) return {};
    const StepReport step = simulation.step();
    progress.report(step.time / simulation.end_time(), "");
    if (step.stage != stage) {
      stage = step.stage;
      stage_began = step.time - step.time_step;
      moments = moments_of(given.stages[static_cast<std::size_t>(stage)]);
      next = 0;
    }
    for (; next < moments.size() && step.time - stage_began >= moments[next] - slack; ++next)
      ways.push_back(simulation.frame(0).displacement);
  }
  if (!simulation.converged()) return {};
  return ways;
}

}  // namespace

std::optional<double> error_by_step_doubling(const Project& project, const BlockSystem& system, double budget,
                                             Progress& progress) {
  PartOfProgress first(progress, 0, of_run, ""), second(progress, of_run, 1 - of_run, "");
  const auto ways = ways_of(project, system, project, of_run * budget, first);
  if (ways.empty()) return std::nullopt;
  const auto finer = ways_of(in_half_steps(project), system, project, (1 - of_run) * budget, second);
  if (finer.size() != ways.size()) return std::nullopt;
  double longest = 0, apart = 0;
  for (std::size_t m = 0; m < ways.size(); ++m)
    for (std::size_t n = 0; n < ways[m].size(); ++n) {
      longest = std::max(longest, finer[m][n].norm());
      apart = std::max(apart, (ways[m][n] - finer[m][n]).norm());
    }
  if (longest == 0) return std::nullopt;
  const double twice_to_the_order = project.solver.integrator == Integrator::generalized_alpha ? 4 : 2;
  return apart / longest * twice_to_the_order / (twice_to_the_order - 1);
}

}  // namespace talus
