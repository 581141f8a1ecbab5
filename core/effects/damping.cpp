#include "effects/damping.hpp"

#include "effects/inertia.hpp"

namespace talus {

double Damping::energy(const Increment& d) const {
  double sum = 0;
  for (const Element& element : set_.elements)
    sum += rates_[element.body] / (2 * length_) * mass_square(element.mass, set_.corner_increments(element, d));
  return sum;
}

void Damping::add_gradient(const Increment& d, Eigen::VectorXd& sum) const {
  for (const Element& element : set_.elements) {
    const Corners u = set_.corner_increments(element, d);
    const Vec3 total = u[0] + u[1] + u[2] + u[3];
    const double scale = rates_[element.body] * element.mass / (20 * length_);
    for (int a = 0; a < 4; ++a) sum.segment<3>(3 * element.freedoms[a]) += scale * (total + u[a]);
  }
}

void Damping::add_hessian(const Increment&, SymmetricBlocks& sum) const {
  for (const Element& element : set_.elements) {
    const Mat3 block = rates_[element.body] * element.mass / (20 * length_) * Mat3::Identity();
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b <= a; ++b) sum.add(element.freedoms[a], element.freedoms[b], a == b ? 2 * block : block);
  }
}

}  // namespace talus
