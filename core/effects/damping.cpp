#include "effects/damping.hpp"

#include "effects/consistent_mass.hpp"

namespace talus {

double Damping::energy(const Increment& d) const {
  double sum = 0;
  for (const Element& element : set_.elements)
    sum += rates_[element.body] / (2 * length_) * mass_square(element.mass, set_.corner_increments(element, d));
  return sum;
}

void Damping::add_gradient(const Increment& d, Eigen::VectorXd& sum) const {
  for (const Element& element : set_.elements)
    add_mass_times(element, rate_of(element), set_.corner_increments(element, d), sum);
}

void Damping::add_hessian(const Increment&, SymmetricBlocks& sum) const {
  for (const Element& element : set_.elements) add_mass(element, rate_of(element), sum);
}

double Damping::rate_of(const Element& element) const { return rates_[element.body] * element.mass / (20 * length_); }

}  // namespace talus
