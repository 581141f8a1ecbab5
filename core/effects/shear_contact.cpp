#include "effects/shear_contact.hpp"

namespace talus {

Vec3 ShearContact::spring_force(std::size_t i, const Increment& d) const {
  const ContactPoint& point = contacts_.points[i];
  const Vec3 u = relative_displacement(contacts_, point, set_, d);
  return point.shear_start - point.shear_stiffness * (u - point.normal * point.normal.dot(u));
}

double ShearContact::gap(const ContactPoint& point, const Increment& d) const {
  return point.gap + point.normal.dot(relative_displacement(contacts_, point, set_, d));
}

void ShearContact::update_strength(const Increment& d) {
  strength_.resize(contacts_.points.size());
  for (std::size_t i = 0; i < strength_.size(); ++i) {
    const ContactPoint& point = contacts_.points[i];
    strength_[i] = shear_strength(point, normal_force(point, gap(point, d)));
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
    const bool set_down = strength_[i] == 0 && touching_ > 0 && touches(point, gap(point, d), touching_);
    if (strength_[i] == 0 && !(set_down && point.friction > 0)) continue;
    Mat3 spring = Mat3::Identity() - point.normal * point.normal.transpose();
    const Vec3 trial = spring_force(i, d);
    const double length = trial.norm();
    if (length > strength_[i] && !set_down)
      spring = strength_[i] / length * (spring - trial * trial.transpose() / (length * length));
    add_contact_spring(contacts_, point, set_, point.shear_stiffness * spring, sum);
  }
}

void ShearContact::add_unsymmetric(const Increment& d, UnsymmetricBlocks& sum) const {
  for (std::size_t i = 0; i < contacts_.points.size(); ++i) {
    const ContactPoint& point = contacts_.points[i];
    if (strength_[i] == 0 || point.friction == 0) continue;
    const Vec3 trial = spring_force(i, d);
    const double length = trial.norm();
    if (length <= strength_[i] || !resists_elastically(point, gap(point, d))) continue;
    const Mat3 growth = point.friction * point.normal_stiffness / length * trial * point.normal.transpose();
    for (int a = point.stencil_begin; a < point.stencil_end; ++a)
      for (int b = point.stencil_begin; b < point.stencil_end; ++b) {
        const int m = set_.nodes.freedom[contacts_.nodes[a]], n = set_.nodes.freedom[contacts_.nodes[b]];
        if (m >= 0 && n >= 0) sum.add(m, n, contacts_.weights[a] * contacts_.weights[b] * growth);
      }
  }
}

void ShearContact::accept(const Increment& d) {
  stored_ = 0;
  for (std::size_t i = 0; i < contacts_.points.size(); ++i)
    stored_ += force(i, d).squaredNorm() / (2 * contacts_.points[i].shear_stiffness);
}

double ShearContact::slip(std::size_t i, const Increment& d) const {
  const double spring = spring_force(i, d).norm(), excess = spring - force(i, d).norm();
  return excess > 1e-12 * spring ? excess / contacts_.points[i].shear_stiffness : 0;
}

double ShearContact::dissipated(const Increment& d) const {
  double sum = 0;
  for (std::size_t i = 0; i < contacts_.points.size(); ++i) sum += force(i, d).norm() * slip(i, d);
  return sum;
}

double ShearContact::work_on_held(const Increment& d) const {
  double sum = 0;
  for (std::size_t i = 0; i < contacts_.points.size(); ++i)
    sum += work_on_held_nodes(contacts_, contacts_.points[i], set_, force(i, d));
  return sum;
}

}  // namespace talus
