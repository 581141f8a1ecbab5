#include "effects/inertia.hpp"

namespace talus {

namespace {

/// uᵀ M u of one element: the consistent mass matrix of a four-node tetrahedron is m/20 (1 + δ_ab).
double mass_square(double mass, const Corners& u) {
  const Vec3 sum = u[0] + u[1] + u[2] + u[3];
  double squares = sum.squaredNorm();
  for (const Vec3& corner : u) squares += corner.squaredNorm();
  return mass / 20 * squares;
}

}  // namespace

void Inertia::begin_step(const StepContext& step) { step_ = step; }

Corners Inertia::departure(const Element& element, const Increment& d) const {
  Corners u = set_.corner_increments(element, d);
  const double scale = step_.length * step_.dynamic_factor;
  for (int i = 0; i < 4; ++i) u[i] -= scale * set_.nodes.velocity[element.nodes[i]];
  return u;
}

double Inertia::energy(const Increment& d) const {
  double sum = 0;
  for (const Element& element : set_.elements) sum += mass_square(element.mass, departure(element, d));
  return sum / (step_.length * step_.length);
}

void Inertia::add_gradient(const Increment& d, Eigen::VectorXd& sum) const {
  for (const Element& element : set_.elements) {
    const Corners u = departure(element, d);
    const Vec3 total = u[0] + u[1] + u[2] + u[3];
    const double scale = 2 * element.mass / (20 * step_.length * step_.length);
    for (int a = 0; a < 4; ++a) sum.segment<3>(3 * element.freedoms[a]) += scale * (total + u[a]);
  }
}

void Inertia::add_hessian(const Increment&, SymmetricBlocks& sum) const {
  for (const Element& element : set_.elements) {
    const Mat3 block = 2 * element.mass / (20 * step_.length * step_.length) * Mat3::Identity();
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b <= a; ++b) sum.add(element.freedoms[a], element.freedoms[b], a == b ? 2 * block : block);
  }
}

void Inertia::accept(const Increment& d) {
  NodeSet& nodes = set_.nodes;
  for (std::size_t i = 0; i < nodes.velocity.size(); ++i) {
    if (nodes.freedom[i] < 0) continue;
    Vec3& v = nodes.velocity[i];
    v = step_.dynamic_factor == 0 ? Vec3(Vec3::Zero())
                                  : Vec3(2 / step_.length * set_.node_increment(static_cast<int>(i), d) - v);
  }
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
