#include "effects/inertia.hpp"

#include <algorithm>
#include <cmath>

#include "bodies/consistent_mass.hpp"
#include "bodies/nodal_motion.hpp"
#include "effects/rigid_inertia.hpp"

namespace talus {

double Inertia::energy(const Increment& d) const {
  const double alpha_m = step_.integration.alpha_m;
  double sum = 0;
  for (const Element& element : set_.elements) {
    const double beta = beta_of(set_.bodies[element.body], step_);
    Corners a1, a0, u = set_.corner_increments(element, d), mixed;
    for (int i = 0; i < 4; ++i) {
      a1[i] = end_acceleration(set_, step_, element.nodes[i], d);
      a0[i] = start_acceleration(set_, step_, element.nodes[i]);
      mixed[i] = a0[i] + u[i];
    }
    sum +=
        (1 - alpha_m) * beta / 2 * step_.length * step_.length * mass_square(element.mass, a1) +
        alpha_m / 2 * (mass_square(element.mass, mixed) - mass_square(element.mass, a0) - mass_square(element.mass, u));
  }
  return sum;
}

void Inertia::add_couplings(std::vector<std::pair<int, int>>& couplings) const { set_.add_couplings(couplings); }

void Inertia::add_gradient(const Increment& d, Arms, Eigen::VectorXd& sum) const {
  const double alpha_m = step_.integration.alpha_m;
  for (const Element& element : set_.elements) {
    Corners a;
    for (int i = 0; i < 4; ++i)
      a[i] = (1 - alpha_m) * end_acceleration(set_, step_, element.nodes[i], d) +
             alpha_m * start_acceleration(set_, step_, element.nodes[i]);
    add_mass_times(element, element.mass / 20, a, sum);
  }
  add_rigid_inertia(set_, PickedBodies::turning_of(picked_, set_), step_, d, sum);
}

void Inertia::add_hessian(const Increment&, SymmetricBlocks& sum) const {
  const double scale = (1 - step_.integration.alpha_m) / (20 * step_.length * step_.length);
  for (const Element& element : set_.elements)
    add_mass(element, scale / beta_of(set_.bodies[element.body], step_) * element.mass, sum);
  add_rigid_mass(set_, step_, sum);
}

void Inertia::add_unsymmetric(const Increment& d, Arms, UnsymmetricBlocks& sum) const {
  add_rigid_turning(set_, PickedBodies::turning_of(picked_, set_), step_, d, sum);
}

void Inertia::accept(const Increment& d) {
  NodeSet& nodes = set_.nodes;
  for (const int b : set_.driven)
    for (int n = set_.bodies[b].first_node; n < set_.bodies[b].first_node + set_.bodies[b].node_count; ++n)
      nodes.velocity[n] = step_.dynamic_factor / step_.length * nodes.prescribed[n];
  for (const int n : nodes.free) {
    if (step_.dynamic_factor == 0) {
      nodes.velocity[n] = nodes.acceleration[n] = Vec3::Zero();
      continue;
    }
    const double gamma = step_.integration.gamma;
    const Vec3 a0 = start_acceleration(set_, step_, n), a1 = end_acceleration(set_, step_, n, d);
    nodes.velocity[n] = step_.dynamic_factor * nodes.velocity[n] + step_.length * ((1 - gamma) * a0 + gamma * a1);
    nodes.acceleration[n] = a1;
  }
  accept_rigid(set_, step_, d);
}

double Inertia::time_error(const Increment& d) const {
  double largest = 0;
  const auto is_constant = [&](int node) {
    const Body& body = set_.bodies[set_.nodes.body[node]];
    return body.constant_acceleration && body.kind == BodyKind::rigid;
  };
  for (const int n : set_.nodes.free) {
    if (is_constant(n)) continue;
    largest = std::max(largest, (end_acceleration(set_, step_, n, d) - start_acceleration(set_, step_, n)).norm());
  }
  for (const int r : set_.turning) {
    const RigidBody& body = set_.rigid[r];
    if (is_constant(body.centre)) continue;
    const Vec3 change = end_moment(set_, body, step_, d) - step_.dynamic_factor * body.moment;
    largest = std::max(largest, change.norm() / (body.mass * body.radius));
  }
  return std::abs(step_.integration.beta - 1.0 / 6) * step_.length * step_.length * largest;
}

namespace {

double element_kinetic_energy(const BodySet& set, const Element& element) {
  Corners v;
  for (int i = 0; i < 4; ++i) v[i] = set.nodes.velocity[element.nodes[i]];
  return 0.5 * mass_square(element.mass, v);
}

}  // namespace

double Inertia::kinetic_energy(const BodySet& set) {
  double sum = rigid_kinetic_energy(set);
  for (const Element& element : set.elements) sum += element_kinetic_energy(set, element);
  return sum;
}

double Inertia::kinetic_energy(const BodySet& set, std::span<const int> bodies) {
  double sum = 0;
  for (const int b : bodies) {
    const Body& body = set.bodies[b];
    if (body.fixed) continue;
    if (body.rigid >= 0) sum += talus::kinetic_energy(set, set.rigid[body.rigid]);
    for (int e = body.first_element; e < body.first_element + body.element_count; ++e)
      sum += element_kinetic_energy(set, set.elements[e]);
  }
  return sum;
}

}  // namespace talus
