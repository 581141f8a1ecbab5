#include "effects/damping.hpp"

#include "bodies/consistent_mass.hpp"

namespace talus {

double Damping::energy(const Increment& d) const {
  double sum = 0;
  for (const Element& element : set_.elements)
    sum += rates_[element.body] / (2 * length_) * mass_square(element.mass, set_.corner_increments(element, d));
  for (const int r : set_.turning) {
    const RigidBody& body = set_.rigid[r];
    const Vec3 theta = body.theta(d), u = d.segment<3>(3 * set_.nodes.dof_block[body.centre]);
    sum += rate_of(body) / 2 * (body.mass * u.squaredNorm() + theta.dot(body.momentum_of(theta)));
  }
  return sum;
}

void Damping::add_gradient(const Increment& d, Arms, Eigen::VectorXd& sum) const {
  for (const Element& element : set_.elements)
    add_mass_times(element, rate_of(element), set_.corner_increments(element, d), sum);
  for (const int r : PickedBodies::turning_of(picked_, set_)) {
    const RigidBody& body = set_.rigid[r];
    const int centre = 3 * set_.nodes.dof_block[body.centre], turning = 3 * body.rotation_dof_block;
    sum.segment<3>(centre) += rate_of(body) * body.mass * d.segment<3>(centre);
    sum.segment<3>(turning) += rate_of(body) / body.radius * body.momentum_of(body.theta(d));
  }
}

void Damping::add_hessian(const Increment&, SymmetricBlocks& sum) const {
  for (const Element& element : set_.elements) add_mass(element, rate_of(element), sum);
  for (const int r : set_.turning) {
    const RigidBody& body = set_.rigid[r];
    const int centre = set_.nodes.dof_block[body.centre], turning = body.rotation_dof_block;
    sum.add(centre, centre, rate_of(body) * body.mass * Mat3::Identity());
    sum.add(turning, turning, rate_of(body) / (body.radius * body.radius) * body.inertia_now());
  }
}

void Damping::add_unsymmetric(const Increment& d, Arms, UnsymmetricBlocks& sum) const {
  for (const int r : PickedBodies::turning_of(picked_, set_)) {
    const RigidBody& body = set_.rigid[r];
    sum.add(body.rotation_dof_block, body.rotation_dof_block,
            rate_of(body) / (body.radius * body.radius) * (body.momentum_slope(body.theta(d)) - body.inertia_now()));
  }
}

double Damping::rate_of(const Element& element) const { return rates_[element.body] * element.mass / (20 * length_); }

double Damping::rate_of(const RigidBody& body) const { return rates_[body.body] / length_; }

}  // namespace talus
