#include "render/paint/value_range.hpp"

#include <algorithm>
#include <cmath>

namespace talus {

void ValueRange::include(double value) {
  if (!std::isfinite(value)) return;
  low = std::min(low, value);
  high = std::max(high, value);
}

void ValueRange::include(std::span<const double> values) {
  for (const double value : values) include(value);
}

void ValueRange::include(const ValueRange& other) {
  low = std::min(low, other.low);
  high = std::max(high, other.high);
}

}  // namespace talus
