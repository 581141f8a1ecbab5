#include "solve/dynamics/prescribed_motion.hpp"

#include <algorithm>

#include "model/time_table.hpp"

namespace talus {

namespace {

Vec3 wanted(const Constraint& constraint, double time) {
  if (!constraint.table.empty()) return value_at(constraint.table, time);
  Vec3 displacement;
  for (int k = 0; k < 3; ++k) displacement[k] = constraint.displacement[k].value_or(0);
  return displacement;
}

}  // namespace

PrescribedMotion::PrescribedMotion(const Project& project, const BlockSystem& system) {
  for (const Constraint& constraint : project.constraints)
    for (std::size_t b = 0; b < system.blocks.size() && !constraint.at; ++b)
      if (system.blocks[b].name == constraint.block) moved_.push_back({static_cast<int>(b), constraint});
}

void PrescribedMotion::begin_step(BodySet& bodies, double end) const {
  NodeSet& nodes = bodies.nodes;
  nodes.any_prescribed = !moved_.empty();
  bodies.driven.clear();
  for (const Moved& moved : moved_) bodies.driven.push_back(moved.body);
  for (const auto& [index, constraint] : moved_) {
    const Body& body = bodies.bodies[index];
    const Vec3 place = wanted(constraint, end);
    for (int n = body.first_node; n < body.first_node + body.node_count; ++n)
      nodes.prescribed[n] = nodes.reference[n] + place - nodes.position[n];
  }
}

void PrescribedMotion::stand_still(BodySet& bodies) const {
  for (const Moved& moved : moved_) {
    const Body& body = bodies.bodies[moved.body];
    std::fill_n(bodies.nodes.prescribed.begin() + body.first_node, body.node_count, Vec3::Zero());
  }
}

}  // namespace talus
