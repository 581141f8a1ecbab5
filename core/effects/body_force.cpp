#include "effects/body_force.hpp"

namespace talus {

double BodyForce::energy(const Increment& d) const {
  double sum = 0;
  for (const Element& element : set_.elements)
    for (const int freedom : element.freedoms) sum -= element.mass / 4 * gravity_.dot(d.segment<3>(3 * freedom));
  return sum;
}

void BodyForce::add_gradient(const Increment&, Eigen::VectorXd& sum) const {
  for (const Element& element : set_.elements)
    for (const int freedom : element.freedoms) sum.segment<3>(3 * freedom) -= element.mass / 4 * gravity_;
}

double BodyForce::stored_energy() const {
  double sum = 0;
  for (const Element& element : set_.elements)
    for (const int node : element.nodes)
      sum -= element.mass / 4 * gravity_.dot(set_.nodes.position[node] - set_.nodes.reference[node]);
  return sum;
}

}  // namespace talus
