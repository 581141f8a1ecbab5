#include "study/forecast/run_outline.hpp"

#include <algorithm>
#include <cmath>

#include "base/processor_time.hpp"
#include "bodies/block_motion.hpp"
#include "mesh/unknowns.hpp"
#include "model/stage_length.hpp"
#include "solve/simulation.hpp"

namespace talus {

namespace {

constexpr double steps_of_a_stage = 150;           ///< of the outline, where that makes none longer than …
constexpr double shortest_leap = 2, longest = 20;  ///< … so many of the run's
constexpr int static_steps = 50;                   ///< of a static stage

double leap_of(const Stage& stage) {
  return std::clamp(length_of(stage) / stage.time_step / steps_of_a_stage, shortest_leap, longest);
}

Stage outlined(Stage stage, double shorter) {
  const double length = length_of(stage), steps = length / stage.time_step;
  const double fewer = stage.kind == StageKind::dynamic ? shorter * steps / leap_of(stage)
                                                        : std::min(steps, static_cast<double>(static_steps));
  stage.duration.reset();
  stage.steps = std::max(1, static_cast<int>(std::ceil(fewer - 1e-9)));
  stage.time_step = length / *stage.steps;
  return stage;
}

/// Stress is of no body here; nobody looks at monitors.
Project outline_of(Project project, double shorter) {
  for (Stage& stage : project.stages) stage = outlined(stage, shorter);
  project.solver.time_step_control = TimeStepControl::fixed;
  project.in_situ.clear();
  project.monitors.clear();
  project.expect.clear();
  return project;
}

BlockSystem with_rigid_blocks(BlockSystem system) {
  for (Block& block : system.blocks)
    if (block.body != BodyKind::fixed) block.body = BodyKind::rigid;
  return system;
}

/// Share of the unknowns of the run that belongs to blocks that move in the outline.
double awake_share(const BlockSystem& system, const BodySet& bodies) {
  double all = 0, awake = 0;
  for (const Block& block : system.blocks) all += static_cast<double>(unknowns_of(block));
  for (const int b : bodies.moving) awake += static_cast<double>(unknowns_of(system.blocks[b]));
  return all > 0 ? awake / all : 1;
}

}  // namespace

RunOutline::RunOutline(const Project& project, const BlockSystem& system, double shorter, double budget,
                       Progress& progress) {
  const Project outline = outline_of(project, shorter);
  const BlockSystem rigid = with_rigid_blocks(system);
  Simulation simulation(outline, rigid);
  const double begin = processor_seconds_of_thread();
  double stage_began = 0;
  while (!simulation.finished()) {
    const double spent = processor_seconds_of_thread() - begin;
    if (progress.cancelled()) throw Cancelled{};
    if (spent > budget) break;
    progress.report(std::max(spent / budget, simulation.time() / simulation.end_time()), "");
    const StepReport step = simulation.step();
    if (step.stage >= static_cast<int>(stages_.size())) {
      stages_.resize(step.stage + 1);
      stage_began = step.time - step.time_step;
    }
    stages_[step.stage].push_back({step.time - stage_began,
                                   step.time_step,
                                   {static_cast<double>(step.contacts), awake_share(system, simulation.bodies()),
                                    static_cast<double>(step.iterations)}});
  }
  came_through_ = simulation.finished() && simulation.converged();
  for (std::size_t b = 0; b < system.blocks.size(); ++b)
    displacements_.push_back(block_motion(simulation.bodies(), static_cast<int>(b)).displacement);
}

std::optional<RunOutline::Load> RunOutline::load(int stage, double from, double to) const {
  if (stage >= static_cast<int>(stages_.size())) return std::nullopt;
  Load sum;
  double covered = 0;
  for (const Step& step : stages_[stage]) {
    const double both = std::min(to, step.end) - std::max(from, step.end - step.length);
    if (both <= 0) continue;
    covered += both;
    sum.contacts += both * step.load.contacts;
    sum.awake += both * step.load.awake;
    sum.iterations += both * step.load.iterations;
  }
  if (covered == 0) return std::nullopt;
  return Load{sum.contacts / covered, sum.awake / covered, sum.iterations / covered};
}

std::optional<RunOutline::Load> RunOutline::last() const {
  constexpr std::size_t some = 10;
  if (stages_.empty()) return std::nullopt;
  const std::vector<Step>& steps = stages_.back();
  const Step& first = steps[steps.size() - std::min(some, steps.size())];
  return load(static_cast<int>(stages_.size()) - 1, first.end - first.length, steps.back().end);
}

double longest_leap(const Project& project) {
  double leap = 1;
  for (const Stage& stage : project.stages)
    if (stage.kind == StageKind::dynamic) leap = std::max(leap, leap_of(stage));
  return leap;
}

}  // namespace talus
