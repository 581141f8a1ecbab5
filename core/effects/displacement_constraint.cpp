#include "effects/displacement_constraint.hpp"

#include "model/time_table.hpp"

namespace talus {

void DisplacementConstraints::begin_step(const StepContext& step) {
  for (HeldPoint& held : points_) {
    if (held.table.empty()) continue;
    const Vec3 wanted = value_at(held.table, step.time + step.length);
    for (int k = 0; k < 3; ++k)
      if (held.displacement[k]) held.displacement[k] = wanted[k];
  }
}

Vec3 DisplacementConstraints::excess(const HeldPoint& held, const Increment& d) const {
  const Vec3 start = held.point.at(set_.nodes.position) - held.point.at(set_.nodes.reference);
  Vec3 excess = Vec3::Zero();
  for (int k = 0; k < 3; ++k) {
    if (!held.displacement[k]) continue;
    excess[k] = start[k] - *held.displacement[k];
    for (int i = 0; i < 4; ++i) excess[k] += held.point.weights[i] * set_.node_increment(held.point.nodes[i], d)[k];
  }
  return excess;
}

double DisplacementConstraints::energy(const Increment& d) const {
  double sum = 0;
  for (const HeldPoint& held : points_) sum += 0.5 * held.stiffness * excess(held, d).squaredNorm();
  return sum;
}

void DisplacementConstraints::add_gradient(const Increment& d, Eigen::VectorXd& sum) const {
  for (const HeldPoint& held : points_) {
    const Vec3 force = held.stiffness * excess(held, d);
    for (int i = 0; i < 4; ++i) {
      const int freedom = set_.nodes.freedom[held.point.nodes[i]];
      if (freedom >= 0) sum.segment<3>(3 * freedom) += held.point.weights[i] * force;
    }
  }
}

void DisplacementConstraints::add_hessian(const Increment&, SymmetricBlocks& sum) const {
  for (const HeldPoint& held : points_) {
    Mat3 spring = Mat3::Zero();
    for (int k = 0; k < 3; ++k)
      if (held.displacement[k]) spring(k, k) = held.stiffness;
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b <= a; ++b) {
        const int i = set_.nodes.freedom[held.point.nodes[a]], j = set_.nodes.freedom[held.point.nodes[b]];
        if (i >= 0 && j >= 0) sum.add(i, j, held.point.weights[a] * held.point.weights[b] * spring);
      }
  }
}

}  // namespace talus
