#pragma once

#include <Eigen/Geometry>

#include "bodies/body_set.hpp"

namespace talus::test {

struct Momenta {
  Vec3 linear = Vec3::Zero(), angular = Vec3::Zero();  // kg m/s; kg m²/s, about the origin
};

/// Of all bodies that are not fixed.
inline Momenta momenta(const BodySet& set) {
  Momenta sum;
  for (const RigidBody& rigid : set.rigid) {
    const Vec3 momentum = rigid.mass * set.nodes.velocity[rigid.centre];
    sum.linear += momentum;
    sum.angular += set.nodes.position[rigid.centre].cross(momentum) + rigid.angular_momentum;
  }
  for (const Element& element : set.elements) {
    for (const int a : element.nodes)
      for (const int b : element.nodes) {
        const Vec3 momentum = element.mass / 20 * (a == b ? 2 : 1) * set.nodes.velocity[b];
        sum.linear += momentum;
        sum.angular += set.nodes.position[a].cross(momentum);
      }
  }
  return sum;
}

}  // namespace talus::test
