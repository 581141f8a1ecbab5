#include "solve/trouble_log.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <tuple>

#include "bodies/block_motion.hpp"

namespace talus {

namespace {

constexpr double volume_of_chip = 1e-5;  // – of the block beside it: less than a fortieth of its width

double surface_area(const Block& block) {
  const std::vector<Vec3>& x = block.mesh.nodes;
  double sum = 0;
  for (const auto& [nodes, joint] : block.surface)
    sum += 0.5 * (x[nodes[1]] - x[nodes[0]]).cross(x[nodes[2]] - x[nodes[0]]).norm();
  return sum;
}

}  // namespace

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
  const std::optional<Chip> chip = node >= 0 ? place(node, trouble) : std::nullopt;
  trouble.advice = advice_for(trouble, trial.length, project_.solver, chip);
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

std::optional<Chip> TroubleLog::place(int node, ConvergenceTrouble& trouble) const {
  const Vec3& position = bodies_.nodes.position[node];
  const int body = bodies_.nodes.body[node];
  set_place(trouble, position, body);
  trouble.blocks[0] = system_.blocks[body].name;
  if (trouble.cause == TroubleCause::inverted) return std::nullopt;
  const ContactPoint* nearest = nullptr;
  const auto distance = [&](const ContactPoint& point) { return (point.position - position).squaredNorm(); };
  for (const ContactPoint& point : contacts_.points) {
    const bool touches = point.bodies[0] == body || point.bodies[1] == body;
    if (touches && (!nearest || distance(point) < distance(*nearest))) nearest = &point;
  }
  if (!nearest) return std::nullopt;
  set_place(trouble, nearest->position, body);
  trouble.relative_penetration = std::max(0.0, -nearest->gap / nearest->size);
  const auto [first, second] = std::minmax(nearest->bodies[0], nearest->bodies[1]);
  trouble.blocks = {system_.blocks[first].name, system_.blocks[second].name};
  if (!project_.joints.empty()) trouble.joint = project_.joints[nearest->joint].name;
  return chip_of(first, second);
}

/// Where both are pieces of one solid: only of what cuts leave can the project make one block.
std::optional<Chip> TroubleLog::chip_of(int body_a, int body_b) const {
  const Block &a = system_.blocks[body_a], &b = system_.blocks[body_b];
  const auto& [lesser, greater] = a.volume < b.volume ? std::tie(a, b) : std::tie(b, a);
  if (a.solid != b.solid || !(lesser.volume < volume_of_chip * greater.volume)) return std::nullopt;
  return Chip{lesser.name, 2 * lesser.volume / surface_area(lesser)};
}

}  // namespace talus
