#include "effects/shear_contact.hpp"

#include <limits>

namespace talus {

Vec3 ShearContact::spring_force_at(int i, const Vec3& u) const {
  const ContactPoint& point = links_.point(i);
  return point.shear_start - point.shear_stiffness * (u - point.normal * point.normal.dot(u));
}

void ShearContact::update_strength(const Increment& d) {
  clear_strength();
  for (const int i : points()) follow(i, links_.moves().increment(i, d));
}

void ShearContact::follow(int i, const Vec3& u) {
  const ContactPoint& point = links_.point(i);
  strength_[i] = shear_strength(point, normal_force(point, point.gap + point.normal.dot(u)));
}

void ShearContact::join_with_strength(DisjointSets& together) const {
  for (const int i : points())
    if (strength_[i] > 0) links_.moves().join_bodies(i, together);
}

ContactMode ShearContact::mode(int i, const Increment& d) const {
  if (strength_[i] == 0) return ContactMode::open;
  return spring_force(i, d).norm() <= strength_[i] ? ContactMode::stick : ContactMode::slip;
}

Vec3 ShearContact::turned(int i, const Vec3& spring) const {
  const HeldContact& held = (*held_)[i];
  const Vec3 along = held.friction.normalized();
  return held.across * (spring - along * along.dot(spring));
}

Vec3 ShearContact::force(int i, const Vec3& u) const {
  return is_free(i) ? Vec3(Vec3::Zero()) : force_of(i, spring_force_at(i, u));
}

Vec3 ShearContact::force_of(int i, const Vec3& spring) const {
  if (held_) return (*held_)[i].shear == ContactMode::stick ? spring : (*held_)[i].friction + turned(i, spring);
  const double length = spring.norm();
  return length <= strength_[i] ? spring : Vec3(strength_[i] / length * spring);
}

double ShearContact::energy(const Increment& d) const {
  double sum = 0;
  for (const int i : points()) {
    if (held_ && (*held_)[i].shear != ContactMode::stick) {
      const HeldContact& held = (*held_)[i];
      sum -= held.friction.dot(links_.moves().increment(i, d));  // (37)
      if (held.across > 0)
        sum += turned(i, spring_force(i, d)).squaredNorm() / (2 * held.across * links_.point(i).shear_stiffness);
      continue;
    }
    const double length = spring_force(i, d).norm(), strength = strength_[i], k = links_.point(i).shear_stiffness;
    sum +=
        held_ || length <= strength ? length * length / (2 * k) : strength * length / k - strength * strength / (2 * k);
  }
  return sum;
}

void ShearContact::add_tangent(int i, const Vec3& u, PointTangent& sum) const {
  const ContactPoint& point = links_.point(i);
  if (!held_ && strength_[i] == 0) {
    if (touching_ == 0 || !touches(point, point.gap + point.normal.dot(u), touching_)) return;
    sum.set_down += point.shear_stiffness * (Mat3::Identity() - point.normal * point.normal.transpose());
    sum.has_set_down = true;
    return;
  }
  if (is_free(i)) return;
  const Vec3 trial = spring_force_at(i, u);
  const double length = trial.norm();
  sum.bears = true;
  sum.force -= force_of(i, trial);
  sum.spring += spring_at(i, trial);
  if (held_ || !slides(i, length) || !resists_elastically(point, point.gap + point.normal.dot(u))) return;
  // The strength grows as the gap closes.
  sum.other += point.friction * point.normal_stiffness / length * trial * point.normal.transpose();
  sum.has_other = true;
}

Mat3 ShearContact::spring_at(int i, const Vec3& trial) const {
  const ContactPoint& point = links_.point(i);
  const Mat3 stuck = point.shear_stiffness * (Mat3::Identity() - point.normal * point.normal.transpose());
  const double length = trial.norm();
  if (!slides(i, length)) return stuck;
  if (held_) {
    const Vec3 along = (*held_)[i].friction.normalized();
    return (*held_)[i].across * (stuck - point.shear_stiffness * along * along.transpose());
  }
  return strength_[i] / length * (stuck - point.shear_stiffness * trial * trial.transpose() / (length * length));
}

bool ShearContact::let_slide(const Increment& d) {
  slides_on_.assign(links_.contacts().points.size(), false);
  bool any = false;
  for (const int i : points()) {
    const ContactPoint& point = links_.point(i);
    const double strength = strength_[i];
    const bool slid =
        point.mode == ContactMode::slip && point.shear_start.norm() > (1 - tolerances_.slides_on) * strength;
    if (strength == 0 || !slid || spring_force(i, d).norm() <= strength) continue;
    slides_on_[i] = any = true;
  }
  if (!any) stick();
  return any;
}

void ShearContact::accept(const Increment& d) {
  stored_ = 0;
  for (const int i : points()) stored_ += shear_spring_energy(links_.point(i), force_at(i, d));
}

double ShearContact::slip(int i, const Increment& d) const {
  const double roundings = tolerances_.slip_roundings * std::numeric_limits<double>::epsilon();
  const ContactPoint& point = links_.point(i);
  const double spring = spring_force(i, d).norm(), excess = spring - force_at(i, d).norm();
  const double path = excess / point.shear_stiffness;
  return excess > tolerances_.least_excess * spring &&
                 path > roundings * (point.position.cwiseAbs().maxCoeff() + point.size)
             ? path
             : 0;
}

double ShearContact::dissipated(const Increment& d) const {
  double sum = 0;
  for (const int i : points()) sum += force_at(i, d).norm() * slip(i, d);
  return sum;
}

}  // namespace talus
