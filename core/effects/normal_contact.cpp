#include "effects/normal_contact.hpp"

namespace talus {

double NormalContact::gap(const ContactPoint& point, const Increment& d) const {
  return point.gap + point.normal.dot(relative_displacement(contacts_, point, set_, d));
}

double NormalContact::energy(const Increment& d) const {
  double sum = 0;
  for (const ContactPoint& point : contacts_.points) {
    const double g = gap(point, d), force = normal_force(point, g), k = point.normal_stiffness;
    const bool elastic = force == -k * g;
    sum += elastic ? 0.5 * k * g * g : -force * g - 0.5 * force * force / k;
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
  for (const ContactPoint& point : contacts_.points) {
    const double g = gap(point, d);
    const bool elastic = normal_force(point, g) == -point.normal_stiffness * g;
    if (elastic && (g < 0 || point.bonded))
      add_contact_spring(contacts_, point, set_, point.normal_stiffness * point.normal * point.normal.transpose(), sum);
  }
}

}  // namespace talus
