#include <algorithm>

#include "solve/simulation_state.hpp"
#include "solve/struggle_advice.hpp"

/// Where a simulation struggles. Looked at only when a trial step was hard.
namespace talus {

Struggle& Simulation::note_struggle(StruggleCause cause, int node, int iterations) {
  State& s = *state_;
  Struggle struggle;
  struggle.cause = cause;
  struggle.time = s.context.time;
  struggle.step = s.step;
  struggle.iterations = struggle.most_iterations = iterations;
  if (node >= 0) place_struggle(node, struggle);
  struggle.advice = advice_for(struggle, s.context.length, s.project.solver);
  return struggles_.emplace_back(std::move(struggle));
}

void Simulation::note_late_contact(const ContactDetector::Late& late, int iterations) {
  const auto& blocks = state_->system.blocks;
  Struggle& struggle = note_struggle(StruggleCause::found_late, -1, iterations);
  struggle.blocks = {blocks[late.bodies[0]].name, blocks[late.bodies[1]].name};
  struggle.position = late.position;
  struggle.rest_position = rest_of(late.position, late.bodies[0]);
  struggle.relative_penetration = late.depth;
}

void Simulation::place_struggle(int node, Struggle& struggle) const {
  const State& s = *state_;
  const int body = s.bodies.nodes.body[node];
  struggle.position = s.bodies.nodes.position[node];
  struggle.blocks[0] = s.system.blocks[body].name;
  struggle.rest_position = rest_of(struggle.position, body);
  if (struggle.cause == StruggleCause::inverted) return;
  const ContactPoint* nearest = nullptr;
  const auto distance = [&](const ContactPoint& point) {
    return (point.position - s.bodies.nodes.position[node]).squaredNorm();
  };
  for (const ContactPoint& point : s.contacts.points) {
    const bool touches = point.bodies[0] == body || point.bodies[1] == body;
    if (touches && (!nearest || distance(point) < distance(*nearest))) nearest = &point;
  }
  if (!nearest) return;
  struggle.position = nearest->position;
  struggle.rest_position = rest_of(nearest->position, body);
  struggle.relative_penetration = std::max(0.0, -nearest->gap / nearest->size);
  const auto [first, second] = std::minmax(nearest->bodies[0], nearest->bodies[1]);
  struggle.blocks = {s.system.blocks[first].name, s.system.blocks[second].name};
  if (!s.project.joints.empty()) struggle.joint = s.project.joints[nearest->joint].name;
}

Vec3 Simulation::rest_of(const Vec3& place, int body) const {
  const NodeSet& nodes = state_->bodies.nodes;
  const Body& block = state_->bodies.bodies[body];
  int nearest = block.first_node;
  for (int n = block.first_node; n < block.first_node + block.node_count; ++n)
    if ((nodes.position[n] - place).squaredNorm() < (nodes.position[nearest] - place).squaredNorm()) nearest = n;
  return nodes.reference[nearest] + place - nodes.position[nearest];
}

void Simulation::note_cut(StepReport& report) {
  ++report.cuts;
  struggles_.back().cuts = 1;
}

}  // namespace talus
