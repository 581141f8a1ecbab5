#include "solve/dynamics/initial_motion.hpp"

#include <Eigen/Geometry>

namespace talus {

namespace {

Vec3 centroid(const BodySet& set, const Body& body) {
  if (body.kind == BodyKind::rigid) return set.nodes.position[set.rigid[body.rigid].centre];
  Vec3 sum = Vec3::Zero();
  double mass = 0;
  for (int e = body.first_element; e < body.first_element + body.element_count; ++e) {
    for (const int node : set.elements[e].nodes) sum += set.elements[e].mass / 4 * set.nodes.position[node];
    mass += set.elements[e].mass;
  }
  return sum / mass;
}

void give_velocity(const InitialVelocity& given, int index, BodySet& bodies) {
  const Body& body = bodies.bodies[index];
  const Vec3 centre = centroid(bodies, body);
  for (const int n : bodies.nodes.free)
    if (bodies.nodes.body[n] == index)
      bodies.nodes.velocity[n] = given.linear + given.angular.cross(bodies.nodes.position[n] - centre);
  if (body.kind != BodyKind::rigid) return;
  RigidBody& rigid = bodies.rigid[body.rigid];
  rigid.angular_momentum = rigid.inertia_now() * given.angular;
}

}  // namespace

void give_initial_velocities(const Project& project, const BlockSystem& system, BodySet& bodies) {
  for (const InitialVelocity& given : project.velocities)
    for (std::size_t b = 0; b < system.blocks.size(); ++b)
      if (system.blocks[b].name == given.block && !bodies.bodies[b].fixed)
        give_velocity(given, static_cast<int>(b), bodies);
  bodies.carry_velocities();
}

}  // namespace talus
