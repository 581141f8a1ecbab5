#include "effects/inertia.hpp"

#include <algorithm>
#include <cmath>

#include "effects/consistent_mass.hpp"

namespace talus {

Vec3 Inertia::acceleration(int node, const Increment& d) const {
  const double beta = step_.integration.beta, length = step_.length;
  const Vec3 free = length * step_.dynamic_factor * set_.nodes.velocity[node] +
                    (0.5 - beta) * length * length * start_acceleration(node);
  return (set_.node_increment(node, d) - free) / (beta * length * length);
}

double Inertia::energy(const Increment& d) const {
  const auto [beta, gamma, alpha_m, alpha_f] = step_.integration;
  double sum = 0;
  for (const Element& element : set_.elements) {
    Corners a1, a0, u = set_.corner_increments(element, d), mixed;
    for (int i = 0; i < 4; ++i) {
      a1[i] = acceleration(element.nodes[i], d);
      a0[i] = start_acceleration(element.nodes[i]);
      mixed[i] = a0[i] + u[i];
    }
    sum +=
        (1 - alpha_m) * beta / 2 * step_.length * step_.length * mass_square(element.mass, a1) +
        alpha_m / 2 * (mass_square(element.mass, mixed) - mass_square(element.mass, a0) - mass_square(element.mass, u));
  }
  return sum;
}

void Inertia::add_gradient(const Increment& d, Eigen::VectorXd& sum) const {
  const double alpha_m = step_.integration.alpha_m;
  for (const Element& element : set_.elements) {
    Corners a;
    for (int i = 0; i < 4; ++i)
      a[i] = (1 - alpha_m) * acceleration(element.nodes[i], d) + alpha_m * start_acceleration(element.nodes[i]);
    add_mass_times(element, element.mass / 20, a, sum);
  }
}

void Inertia::add_hessian(const Increment&, SymmetricBlocks& sum) const {
  const double scale = (1 - step_.integration.alpha_m) / (20 * step_.integration.beta * step_.length * step_.length);
  for (const Element& element : set_.elements) add_mass(element, scale * element.mass, sum);
}

void Inertia::accept(const Increment& d) {
  NodeSet& nodes = set_.nodes;
  for (int n = 0; n < static_cast<int>(nodes.velocity.size()); ++n) {
    if (nodes.freedom[n] < 0) {
      nodes.velocity[n] = step_.dynamic_factor / step_.length * nodes.prescribed[n];
    } else if (step_.dynamic_factor == 0) {
      nodes.velocity[n] = nodes.acceleration[n] = Vec3::Zero();
    } else {
      const double gamma = step_.integration.gamma;
      const Vec3 a0 = start_acceleration(n), a1 = acceleration(n, d);
      nodes.velocity[n] = step_.dynamic_factor * nodes.velocity[n] + step_.length * ((1 - gamma) * a0 + gamma * a1);
      nodes.acceleration[n] = a1;
    }
  }
}

double Inertia::time_error(const Increment& d) const {
  double largest = 0;
  for (int n = 0; n < static_cast<int>(set_.nodes.velocity.size()); ++n)
    if (set_.nodes.freedom[n] >= 0) largest = std::max(largest, (acceleration(n, d) - start_acceleration(n)).norm());
  return std::abs(step_.integration.beta - 1.0 / 6) * step_.length * step_.length * largest;
}

double Inertia::kinetic_energy(const BodySet& set) {
  double sum = 0;
  for (const Element& element : set.elements) {
    Corners v;
    for (int i = 0; i < 4; ++i) v[i] = set.nodes.velocity[element.nodes[i]];
    sum += 0.5 * mass_square(element.mass, v);
  }
  return sum;
}

}  // namespace talus
