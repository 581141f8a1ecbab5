#pragma once

#include <Eigen/Core>

#include "model/quantity.hpp"
#include "results/run_report.hpp"

namespace talus {

/// The components of a field at one point: x, y, z, or of a stress xx, yy, zz, xy, yz, zx.
using FieldValue = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 6, 1>;

/// NaN for a stress that was not recorded.
FieldValue field_value(const MonitorSample& sample, Quantity::Field field);

/// The component, or the length, of a value of its field.
double component_of(const FieldValue& value, Quantity::Component component);

}  // namespace talus
