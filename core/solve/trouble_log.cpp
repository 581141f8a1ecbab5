#include "solve/trouble_log.hpp"

#include <algorithm>

#include "bodies/block_motion.hpp"
#include "solve/trouble_advice.hpp"

namespace talus {

void TroubleLog::begin_step(int number) {
  step_ = number;
  troubles_.clear();
}

void TroubleLog::note(TroubleCause cause, int node, const StepContext& trial, int iterations) {
  ConvergenceTrouble& trouble = troubles_.emplace_back();
  trouble.cause = cause;
  trouble.time = trial.time;
  trouble.step = step_;
  trouble.iterations = trouble.most_iterations = iterations;
  if (node >= 0) place(node, trouble);
  trouble.advice = advice_for(trouble, trial.length, project_.solver);
}

void TroubleLog::note_missed_contact(std::span<const int, 2> bodies, const Vec3& position, double depth,
                                     const StepContext& trial, int iterations) {
  note(TroubleCause::missed_contact, -1, trial, iterations);
  ConvergenceTrouble& trouble = troubles_.back();
  trouble.blocks = {system_.blocks[bodies[0]].name, system_.blocks[bodies[1]].name};
  set_place(trouble, position, bodies[0]);
  trouble.relative_penetration = depth;
}

void TroubleLog::set_place(ConvergenceTrouble& trouble, const Vec3& position, int body) const {
  trouble.position = origin_ + position;
  trouble.rest_position = origin_ + place_before_run(bodies_, position, body);
}

void TroubleLog::place(int node, ConvergenceTrouble& trouble) const {
  const Vec3& position = bodies_.nodes.position[node];
  const int body = bodies_.nodes.body[node];
  set_place(trouble, position, body);
  trouble.blocks[0] = system_.blocks[body].name;
  if (trouble.cause == TroubleCause::inverted) return;
  const ContactPoint* nearest = nullptr;
  const auto distance = [&](const ContactPoint& point) { return (point.position - position).squaredNorm(); };
  for (const ContactPoint& point : contacts_.points) {
    const bool touches = point.bodies[0] == body || point.bodies[1] == body;
    if (touches && (!nearest || distance(point) < distance(*nearest))) nearest = &point;
  }
  if (!nearest) return;
  set_place(trouble, nearest->position, body);
  trouble.relative_penetration = std::max(0.0, -nearest->gap / nearest->size);
  const auto [first, second] = std::minmax(nearest->bodies[0], nearest->bodies[1]);
  trouble.blocks = {system_.blocks[first].name, system_.blocks[second].name};
  if (!project_.joints.empty()) trouble.joint = project_.joints[nearest->joint].name;
}

}  // namespace talus
