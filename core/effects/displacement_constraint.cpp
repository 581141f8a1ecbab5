#include "effects/displacement_constraint.hpp"

#include "model/time_table.hpp"

namespace talus {

void DisplacementConstraints::begin_step(const StepContext& step) {
  moves_.clear();
  for (HeldPoint& held : points_) {
    moves_.add(held.point.nodes, held.point.weights);
    if (held.table.empty()) continue;
    const Vec3 wanted = value_at(held.table, step.time + step.length);
    for (int k = 0; k < 3; ++k)
      if (held.displacement[k]) held.displacement[k] = wanted[k];
  }
}

Vec3 DisplacementConstraints::excess(int i, const Increment& d) const {
  const HeldPoint& held = points_[i];
  const Vec3 now = held.point.at(set_.nodes.position) - held.point.at(set_.nodes.reference) + moves_.increment(i, d);
  Vec3 excess = Vec3::Zero();
  for (int k = 0; k < 3; ++k)
    if (held.displacement[k]) excess[k] = now[k] - *held.displacement[k];
  return excess;
}

double DisplacementConstraints::energy(const Increment& d) const {
  double sum = 0;
  for (int i = 0; i < moves_.size(); ++i) sum += 0.5 * points_[i].stiffness * excess(i, d).squaredNorm();
  return sum;
}

void DisplacementConstraints::add_gradient(const Increment& d, Arms arms, Eigen::VectorXd& sum) const {
  for (int i = 0; i < moves_.size(); ++i) moves_.add_force(i, d, points_[i].stiffness * excess(i, d), arms, sum);
}

void DisplacementConstraints::add_hessian(const Increment& d, SymmetricBlocks& sum) const {
  for (int i = 0; i < moves_.size(); ++i) {
    Mat3 spring = Mat3::Zero();
    for (int k = 0; k < 3; ++k)
      if (points_[i].displacement[k]) spring(k, k) = points_[i].stiffness;
    moves_.add_spring(i, d, spring, sum);
  }
}

void DisplacementConstraints::add_unsymmetric(const Increment& d, Arms arms, UnsymmetricBlocks& sum) const {
  for (int i = 0; i < moves_.size(); ++i) moves_.add_turning(i, d, points_[i].stiffness * excess(i, d), arms, sum);
}

}  // namespace talus
