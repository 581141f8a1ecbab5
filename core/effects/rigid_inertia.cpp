#include "effects/rigid_inertia.hpp"

#include <functional>

#include "base/parallel.hpp"
#include "bodies/finite_rotation.hpp"
#include "bodies/nodal_motion.hpp"

namespace talus {

namespace {

constexpr int bodies_worth_a_thread = 100;

/// Calls use(body) for these of the set's rigid bodies, several at once.
template <class Use>
void each_rigid(const BodySet& set, std::span<const int> bodies, const Use& use) {
  const auto use_some = [&](int first, int last) {
    for (int i = first; i < last; ++i) use(set.rigid[bodies[i]]);
  };
  in_parallel(static_cast<int>(bodies.size()), bodies_worth_a_thread, std::ref(use_some));
}

/// What an angular acceleration of one radius weighs in the derivative [1/(m² s²)].
double turning_scale(const BodySet& set, const RigidBody& body, const StepContext& step) {
  const double beta = beta_of(set, step, body.centre);
  return (1 - step.integration.alpha_m) / (beta * step.length * step.length * body.radius * body.radius);
}

/// The inverse of β − γ/4 φ × …, by which Ȧ₁ enters the equation of motion.
Mat3 moment_weight(double beta, double gamma, const Vec3& phi) {
  const Vec3 w = gamma / 4 * phi;
  return (beta * Mat3::Identity() + cross_matrix(w) + w * w.transpose() / beta) / (beta * beta + w.squaredNorm());
}

/// The derivative of Ȧ₁ as the body turns on [N m].
Mat3 moment_slope(const BodySet& set, const RigidBody& body, const StepContext& step, const Increment& d) {
  const double beta = beta_of(set, step, body.centre), gamma = step.integration.gamma, length = step.length;
  const Vec3 theta = body.theta(d), phi = cayley_vector(theta);
  const Vec3 mean = gamma * end_moment(set, body, step, d) + (1 - gamma) * step.dynamic_factor * body.moment;
  return moment_weight(beta, gamma, phi) *
         (body.momentum_slope(theta) / (length * length) - 0.25 * cross_matrix(mean) * cayley_tangent(phi));
}

}  // namespace

Vec3 end_moment(const BodySet& set, const RigidBody& body, const StepContext& step, const Increment& d) {
  const double beta = beta_of(set, step, body.centre), gamma = step.integration.gamma, length = step.length;
  const Vec3 theta = body.theta(d), phi = cayley_vector(theta), at_start = step.dynamic_factor * body.moment;
  const Vec3 free = length * step.dynamic_factor * body.angular_momentum + (0.5 - beta) * length * length * at_start -
                    (1 - gamma) * length * length / 4 * phi.cross(at_start);
  return moment_weight(beta, gamma, phi) * (body.momentum_of(theta) - free) / (length * length);
}

void add_rigid_inertia(const BodySet& set, std::span<const int> bodies, const StepContext& step, const Increment& d,
                       Eigen::VectorXd& sum) {
  const double alpha_m = step.integration.alpha_m;
  each_rigid(set, bodies, [&](const RigidBody& body) {
    const Vec3 a0 = start_acceleration(set, step, body.centre), a1 = end_acceleration(set, step, body.centre, d);
    sum.segment<3>(3 * set.nodes.dof_block[body.centre]) += body.mass * ((1 - alpha_m) * a1 + alpha_m * a0);
    sum.segment<3>(3 * body.rotation_dof_block) +=
        ((1 - alpha_m) * end_moment(set, body, step, d) + alpha_m * step.dynamic_factor * body.moment) / body.radius;
  });
}

void add_rigid_mass(const BodySet& set, const StepContext& step, SymmetricBlocks& sum) {
  for (const int r : set.turning) {
    const RigidBody& body = set.rigid[r];
    const double beta = beta_of(set, step, body.centre);
    const double scale = (1 - step.integration.alpha_m) / (beta * step.length * step.length);
    const int centre = set.nodes.dof_block[body.centre];
    sum.add(centre, centre, scale * body.mass * Mat3::Identity());
    sum.add(body.rotation_dof_block, body.rotation_dof_block, turning_scale(set, body, step) * body.inertia_now());
  }
}

void add_rigid_turning(const BodySet& set, std::span<const int> bodies, const StepContext& step, const Increment& d,
                       UnsymmetricBlocks& sum) {
  const auto turns = [&](const RigidBody& body) { return !body.theta(d).isZero(0); };
  for (const int r : bodies) {
    const int block = set.rigid[r].rotation_dof_block;
    if (turns(set.rigid[r])) sum.make_room(sum.pattern().slot(block, block), block, block);
  }
  each_rigid(set, bodies, [&](const RigidBody& body) {
    if (!turns(body)) return;
    const double scale = (1 - step.integration.alpha_m) / (body.radius * body.radius);
    sum.add(body.rotation_dof_block, body.rotation_dof_block,
            scale * moment_slope(set, body, step, d) - turning_scale(set, body, step) * body.inertia_now());
  });
}

void accept_rigid(BodySet& set, const StepContext& step, const Increment& d) {
  for (const int r : set.turning) {
    RigidBody& body = set.rigid[r];
    if (step.dynamic_factor == 0) {
      body.angular_momentum = body.moment = Vec3::Zero();
      continue;
    }
    const double gamma = step.integration.gamma, factor = step.dynamic_factor;
    const Vec3 moment = end_moment(set, body, step, d);
    body.angular_momentum =
        factor * body.angular_momentum + step.length * ((1 - gamma) * factor * body.moment + gamma * moment);
    body.moment = moment;
  }
}

double kinetic_energy(const BodySet& set, const RigidBody& body) {
  return 0.5 * body.mass * set.nodes.velocity[body.centre].squaredNorm() + 0.5 * body.spin().dot(body.angular_momentum);
}

double rigid_kinetic_energy(const BodySet& set) {
  double sum = 0;
  for (const int r : set.turning) sum += kinetic_energy(set, set.rigid[r]);
  return sum;
}

}  // namespace talus
