#include "run/interpenetration_watch.hpp"

#include <algorithm>

#include "bodies/block_motion.hpp"
#include "solve/simulation.hpp"

namespace talus {

namespace {

/// Of the mesh size. Ten times what contacts may penetrate: no contact that is known gets there unless its joint is
/// given as soft, and then it says so.
constexpr double least_depth = 1e-2;
constexpr double per_known_depth = 2;

}  // namespace

InterpenetrationWatch::InterpenetrationWatch(const BlockSystem& system, const Simulation& simulation)
    : system_(system), simulation_(simulation), shapes_(system, simulation.bodies()) {}

std::optional<ConvergenceTrouble> InterpenetrationWatch::look(const StepReport& step, double known) {
  const double told = per_known_depth * std::max(known, step.max_relative_penetration);
  const auto pair = shapes_.look(simulation_.bodies(), std::max(least_depth, told));
  if (!pair) return std::nullopt;
  ConvergenceTrouble trouble;
  trouble.cause = TroubleCause::interpenetrating;
  trouble.blocks = {system_.blocks[pair->bodies[0]].name, system_.blocks[pair->bodies[1]].name};
  trouble.position = simulation_.origin() + pair->position;
  trouble.rest_position =
      simulation_.origin() + place_before_run(simulation_.bodies(), pair->position, pair->bodies[0]);
  trouble.time = step.time;
  trouble.step = step.step;
  trouble.relative_penetration = pair->depth / pair->size;
  trouble.ended_run = true;
  trouble.advice = "contact between them was lost: a shorter time_step usually helps";
  return trouble;
}

}  // namespace talus
