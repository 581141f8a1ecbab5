#pragma once

#include <limits>
#include <span>

namespace talus {

/// Smallest and largest value, in SI units. Empty (low > high) until something is included.
struct ValueRange {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  bool empty() const { return low > high; }
  void include(double value);
  void include(std::span<const double> values);
  void include(const ValueRange& other);
  bool operator==(const ValueRange&) const = default;
};

}  // namespace talus
