#include "effects/normal_contact.hpp"

namespace talus {

double NormalContact::gap(const ContactPoint& point, const Increment& d) const {
  return point.gap + point.normal.dot(relative_displacement(contacts_, point, set_, d));
}

double NormalContact::energy(const Increment& d) const {
  double sum = 0;
  for (const ContactPoint& point : contacts_.points) {
    const double g = gap(point, d), force = normal_force(point, g), k = point.normal_stiffness;
    sum += resists_elastically(point, g) ? force * force / (2 * k)
                                         : -force * g - force * force / (2 * k) + force * point.multiplier / k;
  }
  return sum;
}

void NormalContact::add_gradient(const Increment& d, Eigen::VectorXd& sum) const {
  for (const ContactPoint& point : contacts_.points) {
    const double force = normal_force(point, gap(point, d));
    if (force != 0) subtract_contact_force(contacts_, point, set_, force * point.normal, sum);
  }
}

void NormalContact::add_hessian(const Increment& d, SymmetricBlocks& sum) const {
  for (const ContactPoint& point : contacts_.points)
    if (resists_elastically(point, gap(point, d)) || touches(point, gap(point, d), touching_))
      add_contact_spring(contacts_, point, set_, point.normal_stiffness * point.normal * point.normal.transpose(), sum);
}

void NormalContact::accept(const Increment& d) {
  stored_ = 0;
  for (const ContactPoint& point : contacts_.points) {
    const double compression = (normal_force(point, gap(point, d)) - point.multiplier) / point.normal_stiffness;
    if (resists_elastically(point, gap(point, d)) || point.bonded)
      stored_ += 0.5 * point.normal_stiffness * compression * compression;
  }
}

double NormalContact::work_on_held(const Increment& d) const {
  double sum = 0;
  for (const ContactPoint& point : contacts_.points)
    sum += work_on_held_nodes(contacts_, point, set_, normal_force(point, gap(point, d)) * point.normal);
  return sum;
}

}  // namespace talus
