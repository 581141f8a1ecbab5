#include "effects/normal_contact.hpp"

namespace talus {

double NormalContact::force(int i, double gap) const {
  const ContactPoint& point = links_.point(i);
  if (!held_) return normal_force(point, gap);
  return (*held_)[i].closed ? point.multiplier - point.normal_stiffness * gap : -point.tension;
}

bool NormalContact::has_spring(int i, double gap) const {
  return held_ ? (*held_)[i].closed : resists_elastically(links_.point(i), gap);
}

double NormalContact::energy(const Increment& d) const {
  double sum = 0;
  for (const int i : *points_) {
    const ContactPoint& point = links_.point(i);
    const double g = links_.gap(i, d), force = this->force(i, g), k = point.normal_stiffness;
    sum += has_spring(i, g) ? force * force / (2 * k)
                            : -force * g - force * force / (2 * k) + force * point.multiplier / k;
  }
  return sum;
}

void NormalContact::add_gradient(const Increment& d, Arms arms, Eigen::VectorXd& sum) const {
  for (const int i : *points_) {
    const ContactPoint& point = links_.point(i);
    const double force = this->force(i, links_.gap(i, d));
    if (force != 0) links_.moves().add_force(i, d, -force * point.normal, arms, sum);
  }
}

void NormalContact::add_hessian(const Increment& d, SymmetricBlocks& sum) const {
  Attachments::Springs springs(links_.moves(), d, sum);
  for (const int i : *points_) {
    const ContactPoint& point = links_.point(i);
    const double g = links_.gap(i, d);
    if (has_spring(i, g) || (!held_ && touches(point, g, touching_)))
      springs.add(i, point.normal_stiffness * point.normal * point.normal.transpose());
  }
}

void NormalContact::add_unsymmetric(const Increment& d, Arms arms, UnsymmetricBlocks& sum) const {
  if (!links_.moves().any_turns()) return;
  Attachments::Tangent tangent(links_.moves(), d, arms, sum);
  for (const int i : *points_) {
    const ContactPoint& point = links_.point(i);
    const double gap = links_.gap(i, d), force = this->force(i, gap), stiffness = point.normal_stiffness;
    const bool has_spring = this->has_spring(i, gap);
    if (force != 0 || has_spring)
      tangent.add(i, -force * point.normal, (has_spring ? stiffness : 0) * point.normal * point.normal.transpose(),
                  Mat3::Zero());
  }
}

void NormalContact::join_touching(const Increment& d, const Eigen::VectorXd& change, DisjointSets& together) const {
  for (const int i : *points_) {
    const ContactPoint& point = links_.point(i);
    const double least = links_.gap(i, d) + links_.moves().farthest_against(i, d, point.normal, change);
    const bool may_push = point.bonded || least < tolerances_.search_gap * point.size || normal_force(point, least) > 0;
    if (may_push) links_.moves().join_dof_blocks(i, together);
  }
}

void NormalContact::accept(const Increment& d) {
  stored_ = 0;
  for (const int i : *points_) stored_ += normal_spring_energy(links_.point(i), force(i, links_.gap(i, d)));
}

double NormalContact::work_on_held(const Increment& d) const {
  double sum = 0;
  for (const int i : *points_) {
    const ContactPoint& point = links_.point(i);
    sum -= links_.moves().work_on_held(i, force(i, links_.gap(i, d)) * point.normal);
  }
  return sum;
}

}  // namespace talus
