#include "bodies/rigid_motion.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <span>

#include "bodies/finite_rotation.hpp"

namespace talus {

namespace {

struct Spin {
  Vec3 centre = Vec3::Zero();    ///< m
  Vec3 velocity = Vec3::Zero();  ///< m/s, of the centre
  Vec3 rate = Vec3::Zero();      ///< rad/s
};

/// The nodes that carry a body which deforms: all of its own, or the corners of an affine one.
std::span<const int> control_nodes(const BodySet& set, const Body& body, std::size_t first) {
  return std::span(set.nodes.free).subspan(first, body.kind == BodyKind::affine ? 4 : body.node_count);
}

/// The rigid motion nearest to the velocities of nodes, each with the same weight.
Spin spin_of(const BodySet& set, std::span<const int> nodes) {
  Spin spin;
  const auto count = static_cast<double>(nodes.size());
  for (const int n : nodes) {
    spin.centre += set.nodes.position[n] / count;
    spin.velocity += set.nodes.velocity[n] / count;
  }
  Mat3 inertia = Mat3::Zero();
  Vec3 momentum = Vec3::Zero();
  for (const int n : nodes) {
    const Vec3 arm = set.nodes.position[n] - spin.centre;
    inertia += arm.squaredNorm() * Mat3::Identity() - arm * arm.transpose();
    momentum += arm.cross(set.nodes.velocity[n] - spin.velocity);
  }
  spin.rate = inertia.ldlt().solve(momentum);
  return spin;
}

void continue_deformable(const BodySet& set, std::span<const int> nodes, double length, Increment& d) {
  const Spin spin = spin_of(set, nodes);
  for (const int n : nodes) {
    const Vec3 arm = set.nodes.position[n] - spin.centre;
    const Vec3 beside = set.nodes.velocity[n] - spin.velocity - spin.rate.cross(arm);
    d.segment<3>(3 * set.nodes.dof_block[n]) = turn_of(length * spin.rate, arm) + length * (spin.velocity + beside);
  }
}

}  // namespace

void continue_motion(const BodySet& set, double length, Increment& d) {
  d.resize(set.unknowns());
  std::size_t first = 0;  // into the free nodes, which run through the moving bodies
  for (const int b : set.moving) {
    const Body& body = set.bodies[b];
    if (body.kind == BodyKind::rigid) {
      const RigidBody& rigid = set.rigid[body.rigid];
      d.segment<3>(3 * set.nodes.dof_block[rigid.centre]) = length * set.nodes.velocity[rigid.centre];
      d.segment<3>(3 * rigid.rotation_dof_block) = length * rigid.radius * rigid.spin();
      ++first;
      continue;
    }
    const std::span<const int> nodes = control_nodes(set, body, first);
    continue_deformable(set, nodes, length, d);
    first += nodes.size();
  }
}

}  // namespace talus
