#include "bodies/rigid_motion.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <span>

#include "bodies/finite_rotation.hpp"

namespace talus {

namespace {

/// The rigid motion nearest to what some nodes do, ways [m] or velocities [m/s].
struct RigidPart {
  Vec3 centre = Vec3::Zero();  ///< m, the middle of the nodes
  Vec3 mean = Vec3::Zero();    ///< of what they do
  Vec3 turn = Vec3::Zero();    ///< a rotation vector [rad], or its rate [rad/s]
};

/// That of `way(node)` of the nodes of a body that deforms at `place(node)` [m], each with the same weight.
template <class Place, class Way>
RigidPart rigid_part(const Body& body, const Place& place, const Way& way) {
  const int first = body.first_free(), end = first + body.free_count();
  RigidPart part;
  for (int n = first; n < end; ++n) {
    part.centre += place(n) / (end - first);
    part.mean += way(n) / (end - first);
  }
  Mat3 inertia = Mat3::Zero();
  Vec3 momentum = Vec3::Zero();
  for (int n = first; n < end; ++n) {
    const Vec3 arm = place(n) - part.centre;
    inertia += arm.squaredNorm() * Mat3::Identity() - arm * arm.transpose();
    momentum += arm.cross(way(n) - part.mean);
  }
  part.turn = inertia.ldlt().solve(momentum);
  return part;
}

void continue_deformable(const BodySet& set, const Body& body, double length, Increment& d) {
  const auto place = [&](int n) { return set.nodes.position[n]; };
  const RigidPart part = rigid_part(body, place, [&](int n) { return set.nodes.velocity[n]; });
  for (int n = body.first_free(); n < body.first_free() + body.free_count(); ++n) {
    const Vec3 arm = place(n) - part.centre, beside = set.nodes.velocity[n] - part.mean - part.turn.cross(arm);
    d.segment<3>(3 * set.nodes.dof_block[n]) = turn_of(length * part.turn, arm) + length * (part.mean + beside);
  }
}

}  // namespace

void continue_motion(const BodySet& set, double length, Increment& d) {
  d.resize(set.unknowns());
  for (const int b : set.moving) {
    const Body& body = set.bodies[b];
    if (body.kind == BodyKind::rigid) {
      const RigidBody& rigid = set.rigid[body.rigid];
      d.segment<3>(3 * set.nodes.dof_block[rigid.centre]) = length * set.nodes.velocity[rigid.centre];
      d.segment<3>(3 * rigid.rotation_dof_block) = length * rigid.radius * rigid.spin();
    } else {
      continue_deformable(set, body, length, d);
    }
  }
}

void turn_on(const BodySet& set, const Body& body, const Increment& from, const Eigen::VectorXd& change,
             Increment& to) {
  const auto of = [&](const Eigen::VectorXd& d, int n) -> Vec3 { return d.segment<3>(3 * set.nodes.dof_block[n]); };
  const auto place = [&](int n) -> Vec3 { return set.nodes.position[n] + of(from, n); };
  const RigidPart part = rigid_part(body, place, [&](int n) { return of(change, n); });
  for (int n = body.first_free(); n < body.first_free() + body.free_count(); ++n) {
    const Vec3 arm = place(n) - part.centre;
    to.segment<3>(3 * set.nodes.dof_block[n]) += turn_of(part.turn, arm) - part.turn.cross(arm);
  }
}

}  // namespace talus
