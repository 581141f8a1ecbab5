#include "effects/normal_contact.hpp"

namespace talus {

double NormalContact::force_at_gap(int i, double gap) const {
  const ContactPoint& point = links_.point(i);
  if (!held_) return normal_force(point, gap);
  return (*held_)[i].closed ? point.multiplier - point.normal_stiffness * gap : -point.tension;
}

bool NormalContact::has_spring(int i, double gap) const {
  return held_ ? (*held_)[i].closed : resists_elastically(links_.point(i), gap);
}

double NormalContact::energy(const Increment& d) const {
  double sum = 0;
  for (const int i : points()) {
    const ContactPoint& point = links_.point(i);
    const double g = links_.gap(i, d), force = force_at_gap(i, g), k = point.normal_stiffness;
    sum += has_spring(i, g) ? force * force / (2 * k)
                            : -force * g - force * force / (2 * k) + force * point.multiplier / k;
  }
  return sum;
}

Vec3 NormalContact::force(int i, const Vec3& u) const {
  const ContactPoint& point = links_.point(i);
  return force_at_gap(i, point.gap + point.normal.dot(u)) * point.normal;
}

void NormalContact::add_tangent(int i, const Vec3& u, PointTangent& sum) const {
  const ContactPoint& point = links_.point(i);
  const double gap = point.gap + point.normal.dot(u), force = force_at_gap(i, gap);
  const bool has_spring = this->has_spring(i, gap);
  const bool set_down = !has_spring && !held_ && touches(point, gap, touching_);
  if (force != 0 || has_spring) {
    sum.bears = true;
    sum.force -= force * point.normal;
  }
  if (!has_spring && !set_down) return;
  (set_down ? sum.set_down : sum.spring) += point.normal_stiffness * point.normal * point.normal.transpose();
  sum.has_set_down = sum.has_set_down || set_down;
}

void NormalContact::join_touching(const Increment& d, const Eigen::VectorXd& change, DisjointSets& together) const {
  for (const int i : points()) {
    if (links_.moves().bodies_are_together(i, together)) continue;  // in a crowd most are, and need not be looked at
    const ContactPoint& point = links_.point(i);
    const double least = links_.gap(i, d) + links_.moves().farthest_against(i, d, point.normal, change);
    const bool may_push = point.bonded || least < tolerances_.search_gap * point.size || normal_force(point, least) > 0;
    if (may_push) links_.moves().join_bodies(i, together);
  }
}

void NormalContact::accept(const Increment& d) {
  stored_ = 0;
  for (const int i : points()) stored_ += normal_spring_energy(links_.point(i), force_at_gap(i, links_.gap(i, d)));
}

}  // namespace talus
