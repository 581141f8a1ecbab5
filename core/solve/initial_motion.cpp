#include "solve/initial_motion.hpp"

#include <Eigen/Geometry>

namespace talus {

namespace {

Vec3 centroid(const BodySet& set, const Body& body) {
  Vec3 sum = Vec3::Zero();
  double mass = 0;
  for (int e = body.first_element; e < body.first_element + body.element_count; ++e) {
    for (const int node : set.elements[e].nodes) sum += set.elements[e].mass / 4 * set.nodes.position[node];
    mass += set.elements[e].mass;
  }
  return sum / mass;
}

}  // namespace

void give_initial_velocities(const Project& project, const BlockSystem& system, BodySet& bodies) {
  for (const InitialVelocity& given : project.velocities)
    for (std::size_t b = 0; b < system.blocks.size(); ++b) {
      const Body& body = bodies.bodies[b];
      if (system.blocks[b].name != given.block || body.fixed) continue;
      const Vec3 centre = centroid(bodies, body);
      for (int n = body.first_node; n < body.first_node + body.node_count; ++n)
        bodies.nodes.velocity[n] = given.linear + given.angular.cross(bodies.nodes.position[n] - centre);
    }
}

}  // namespace talus
