#pragma once

#include <string>
#include <vector>

namespace talus {

/// A logarithmic axis of positive values.
struct LogAxis {
  double low = 0.1, high = 10;
  std::vector<double> ticks;  ///< those with a label: powers of ten, and 2 and 5 times them where there are few decades
  std::vector<double> lesser_ticks;
  /// 0 … 1 along the axis.
  double share(double value) const;
};

/// Holds all values with some room at both ends; none, or values of one size, give a decade at least.
LogAxis make_log_axis(const std::vector<double>& values);

/// A relative error for people: "1.5 %", "2.0×10⁻⁴ %".
std::string error_text(double error);

/// The same for the number of a tick: "0.1 %", "10⁻⁴ %".
std::string error_tick_text(double tick);

/// A tick without superfluous digits: "0.05", "200".
std::string tick_text(double tick);

}  // namespace talus
