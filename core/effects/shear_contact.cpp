#include "effects/shear_contact.hpp"

namespace talus {

Vec3 ShearContact::spring_force(std::size_t i, const Increment& d) const {
  const ContactPoint& point = contacts_.points[i];
  const Vec3 u = relative_displacement(contacts_, point, set_, d);
  return point.shear_start - point.shear_stiffness * (u - point.normal * point.normal.dot(u));
}

void ShearContact::update_strength(const Increment& d) {
  strength_.resize(contacts_.points.size());
  for (std::size_t i = 0; i < strength_.size(); ++i) {
    const ContactPoint& point = contacts_.points[i];
    const double gap = point.gap + point.normal.dot(relative_displacement(contacts_, point, set_, d));
    strength_[i] = shear_strength(point, normal_force(point, gap));
  }
}

Vec3 ShearContact::force(std::size_t i, const Increment& d) const {
  if (strength_[i] == 0) return Vec3::Zero();
  const Vec3 spring = spring_force(i, d);
  const double length = spring.norm();
  return length <= strength_[i] ? spring : Vec3(strength_[i] / length * spring);
}

double ShearContact::energy(const Increment& d) const {
  double sum = 0;
  for (std::size_t i = 0; i < contacts_.points.size(); ++i) {
    const double length = spring_force(i, d).norm(), strength = strength_[i];
    const double k = contacts_.points[i].shear_stiffness;
    sum += length <= strength ? length * length / (2 * k) : strength * length / k - strength * strength / (2 * k);
  }
  return sum;
}

void ShearContact::add_gradient(const Increment& d, Eigen::VectorXd& sum) const {
  for (std::size_t i = 0; i < contacts_.points.size(); ++i)
    if (strength_[i] > 0) subtract_contact_force(contacts_, contacts_.points[i], set_, force(i, d), sum);
}

void ShearContact::add_hessian(const Increment& d, SymmetricBlocks& sum) const {
  for (std::size_t i = 0; i < contacts_.points.size(); ++i) {
    const ContactPoint& point = contacts_.points[i];
    if (strength_[i] == 0) continue;
    Mat3 spring = Mat3::Identity() - point.normal * point.normal.transpose();
    const Vec3 trial = spring_force(i, d);
    const double length = trial.norm();
    if (length > strength_[i])
      spring = strength_[i] / length * (spring - trial * trial.transpose() / (length * length));
    add_contact_spring(contacts_, point, set_, point.shear_stiffness * spring, sum);
  }
}

}  // namespace talus
