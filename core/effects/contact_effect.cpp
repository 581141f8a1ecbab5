#include "effects/contact_effect.hpp"

namespace talus {

void ContactEffect::add_gradient(const Increment& d, Arms arms, Eigen::VectorXd& sum) const {
  for (const int i : points()) {
    const Vec3 force = this->force(i, links_.moves().increment(i, d));
    if (!force.isZero(0)) links_.moves().add_force(i, d, -force, arms, sum);
  }
}

void ContactEffect::add_hessian(const Increment& d, SymmetricBlocks& sum) const {
  add_tangents(d, Arms::end, &sum, nullptr);
}

void ContactEffect::add_unsymmetric(const Increment& d, Arms arms, UnsymmetricBlocks& sum) const {
  add_tangents(d, arms, nullptr, &sum);
}

void ContactEffect::add_tangents(const Increment& d, Arms arms, SymmetricBlocks* symmetric,
                                 UnsymmetricBlocks* unsymmetric) const {
  Attachments::Tangent tangent(links_.moves(), d, arms, symmetric, unsymmetric);
  for (const int i : points()) {
    PointTangent at;
    add_tangent(i, links_.moves().increment(i, d), at);
    tangent.add(i, at);
  }
}

double ContactEffect::work_on_held(const Increment& d) const {
  double sum = 0;
  for (const int i : points()) sum -= links_.moves().work_on_held(i, force(i, links_.moves().increment(i, d)));
  return sum;
}

}  // namespace talus
