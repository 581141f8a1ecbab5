#include "results/monitor_value.hpp"

#include <limits>

namespace talus {

FieldValue field_value(const MonitorSample& sample, Quantity::Field field) {
  switch (field) {
    case Quantity::Field::velocity:
      return sample.velocity;
    case Quantity::Field::stress:
      return sample.stress.value_or(Voigt::Constant(std::numeric_limits<double>::quiet_NaN()));
    case Quantity::Field::displacement:
      break;
  }
  return sample.displacement;
}

double component_of(const FieldValue& value, Quantity::Component component) {
  using Component = Quantity::Component;
  if (component == Component::magnitude) return value.norm();
  const Component first = component >= Component::xx ? Component::xx : Component::x;
  return value[static_cast<Eigen::Index>(component) - static_cast<Eigen::Index>(first)];
}

}  // namespace talus
