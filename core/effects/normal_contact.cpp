#include "effects/normal_contact.hpp"

namespace talus {

double NormalContact::energy(const Increment& d) const {
  double sum = 0;
  for (const int i : points_) {
    const ContactPoint& point = links_.point(i);
    const double g = links_.gap(i, d), force = normal_force(point, g), k = point.normal_stiffness;
    sum += resists_elastically(point, g) ? force * force / (2 * k)
                                         : -force * g - force * force / (2 * k) + force * point.multiplier / k;
  }
  return sum;
}

void NormalContact::add_gradient(const Increment& d, Eigen::VectorXd& sum) const {
  for (const int i : points_) {
    const ContactPoint& point = links_.point(i);
    const double force = normal_force(point, links_.gap(i, d));
    if (force != 0) links_.moves().add_force(i, d, -force * point.normal, sum);
  }
}

void NormalContact::add_hessian(const Increment& d, SymmetricBlocks& sum) const {
  for (const int i : points_) {
    const ContactPoint& point = links_.point(i);
    const double g = links_.gap(i, d);
    if (resists_elastically(point, g) || touches(point, g, touching_))
      links_.moves().add_spring(i, d, point.normal_stiffness * point.normal * point.normal.transpose(), sum);
  }
}

void NormalContact::add_unsymmetric(const Increment& d, UnsymmetricBlocks& sum) const {
  if (!links_.moves().any_turns()) return;
  for (const int i : points_) {
    const ContactPoint& point = links_.point(i);
    const double force = normal_force(point, links_.gap(i, d));
    if (force != 0) links_.moves().add_turning(i, d, -force * point.normal, sum);
    if (resists_elastically(point, links_.gap(i, d)))
      links_.moves().add_lever_difference(i, d, point.normal_stiffness * point.normal * point.normal.transpose(), sum);
  }
}

void NormalContact::join_meeting(const Increment& d, const Eigen::VectorXd& step, DisjointSets& together) const {
  constexpr double apart = 1e-6;  // of the mesh size: open by more than a tangent takes for closed
  for (const int i : points_) {
    const ContactPoint& point = links_.point(i);
    const double least = links_.gap(i, d) + links_.moves().farthest_against(i, d, point.normal, step);
    const bool may_push = point.bonded || least < apart * point.size || normal_force(point, least) > 0;
    if (may_push) links_.moves().join_freedoms(i, together);
  }
}

void NormalContact::accept(const Increment& d) {
  stored_ = 0;
  for (const int i : points_) {
    const ContactPoint& point = links_.point(i);
    const double force = normal_force(point, links_.gap(i, d));
    if (force == 0) continue;
    const double compression = (force - point.multiplier) / point.normal_stiffness;
    stored_ += 0.5 * point.normal_stiffness * compression * compression;
  }
}

double NormalContact::work_on_held(const Increment& d) const {
  double sum = 0;
  for (const int i : points_) {
    const ContactPoint& point = links_.point(i);
    sum -= links_.moves().work_on_held(i, normal_force(point, links_.gap(i, d)) * point.normal);
  }
  return sum;
}

}  // namespace talus
