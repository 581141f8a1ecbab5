#include "bodies/rigid_motion.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

namespace talus {

namespace {

struct Spin {
  Vec3 centre = Vec3::Zero();    ///< m
  Vec3 velocity = Vec3::Zero();  ///< m/s, of the centre
  Vec3 rate = Vec3::Zero();      ///< rad/s
};

/// The rigid motion nearest to the velocities of a body's nodes, each with the same weight.
Spin spin_of(const BodySet& set, const Body& body) {
  Spin spin;
  const int end = body.first_node + body.node_count;
  for (int n = body.first_node; n < end; ++n) {
    spin.centre += set.nodes.position[n] / body.node_count;
    spin.velocity += set.nodes.velocity[n] / body.node_count;
  }
  Mat3 inertia = Mat3::Zero();
  Vec3 momentum = Vec3::Zero();
  for (int n = body.first_node; n < end; ++n) {
    const Vec3 arm = set.nodes.position[n] - spin.centre;
    inertia += arm.squaredNorm() * Mat3::Identity() - arm * arm.transpose();
    momentum += arm.cross(set.nodes.velocity[n] - spin.velocity);
  }
  spin.rate = inertia.ldlt().solve(momentum);
  return spin;
}

}  // namespace

void continue_motion(const BodySet& set, double length, Increment& d) {
  d.resize(set.unknowns());
  for (const Body& body : set.bodies) {
    if (body.fixed) continue;
    const Spin spin = spin_of(set, body);
    const double angle = length * spin.rate.norm();
    const Mat3 turn =
        angle > 0 ? Eigen::AngleAxisd(angle, spin.rate.normalized()).toRotationMatrix() : Mat3::Identity();
    for (int n = body.first_node; n < body.first_node + body.node_count; ++n) {
      const Vec3 arm = set.nodes.position[n] - spin.centre;
      const Vec3 beside = set.nodes.velocity[n] - spin.velocity - spin.rate.cross(arm);
      d.segment<3>(3 * set.nodes.freedom[n]) = turn * arm - arm + length * (spin.velocity + beside);
    }
  }
}

}  // namespace talus
