#include "effects/body_force.hpp"

namespace talus {

double BodyForce::energy(const Increment& d) const {
  double sum = 0;
  for (const Element& element : set_.elements)
    for (const int dof_block : element.dof_blocks) sum -= element.mass / 4 * gravity_.dot(d.segment<3>(3 * dof_block));
  for (const int r : set_.turning)
    sum -= set_.rigid[r].mass * gravity_.dot(d.segment<3>(3 * set_.nodes.dof_block[set_.rigid[r].centre]));
  return sum;
}

void BodyForce::add_gradient(const Increment&, Arms, Eigen::VectorXd& sum) const {
  for (const Element& element : set_.elements)
    for (const int dof_block : element.dof_blocks) sum.segment<3>(3 * dof_block) -= element.mass / 4 * gravity_;
  for (const int r : PickedBodies::turning_of(picked_, set_))
    sum.segment<3>(3 * set_.nodes.dof_block[set_.rigid[r].centre]) -= set_.rigid[r].mass * gravity_;
}

double BodyForce::stored_energy() const {
  double sum = 0;
  for (const Element& element : set_.elements)
    for (const int node : element.nodes)
      sum -= element.mass / 4 * gravity_.dot(set_.nodes.position[node] - set_.nodes.reference[node]);
  for (const int r : set_.turning) {
    const int centre = set_.rigid[r].centre;
    sum -= set_.rigid[r].mass * gravity_.dot(set_.nodes.position[centre] - set_.nodes.reference[centre]);
  }
  return sum;
}

}  // namespace talus
