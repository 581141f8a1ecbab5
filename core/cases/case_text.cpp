#include "cases/case_text.hpp"

#include <cmath>
#include <cstdio>

namespace talus {

std::string decimals(double value, int digits) {
  const double unit = std::pow(10.0, digits);
  if (std::abs(value) * unit < 0.5) value = 0;
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

std::string significant(double value, int digits) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

std::string direction_text(const Vec3& direction) {
  if (direction.isZero()) return "–";
  return "(" + decimals(direction.x(), 2) + ", " + decimals(direction.y(), 2) + ", " + decimals(direction.z(), 2) + ")";
}

}  // namespace talus
