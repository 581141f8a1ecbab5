#include "report/words.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "render/paint/numbers.hpp"

namespace talus::report {

namespace {

std::string in_brackets(const std::string& x, const std::string& y, const std::string& z) {
  return "(" + x + ",\u00a0" + y + ",\u00a0" + z + ")";
}

}  // namespace

Prefixed prefixed(const std::string& si_unit, double magnitude) {
  constexpr double rounding = 1e-9;  // m, m/s: below a thousandth of the smallest prefix
  if ((si_unit == "m" || si_unit == "m/s") && magnitude < rounding) return {si_unit, 1};
  const DisplayUnit unit = display_unit(si_unit, magnitude);
  return {unit.name, unit.factor};
}

std::string quantity(double value, const std::string& si_unit, int significant) {
  const Prefixed unit = prefixed(si_unit, std::abs(value));
  return format_number(value * unit.factor, significant) + "\u00a0" + unit.unit;
}

std::string given(double value) {
  constexpr int digits = 6;
  const std::string text = format_number(value, digits);
  const std::size_t power = std::min(text.find("×"), text.size());
  std::string mantissa = text.substr(0, power);
  if (mantissa.find('.') != std::string::npos) mantissa.erase(mantissa.find_last_not_of('0') + 1);
  if (mantissa.ends_with('.')) mantissa.pop_back();
  return mantissa + text.substr(power);
}

std::string percent(double share, int significant) { return format_number(100 * share, significant) + "\u00a0%"; }

int decimals_for(double largest, int significant) {
  if (!(largest > 0)) return 0;
  return std::clamp(significant - 1 - static_cast<int>(std::floor(std::log10(largest))), 0, 6);
}

std::string given(const Vec3& vector) { return in_brackets(given(vector.x()), given(vector.y()), given(vector.z())); }

std::string vector_text(const Vec3& vector, int decimals) {
  return in_brackets(format_decimals(vector.x(), decimals), format_decimals(vector.y(), decimals),
                     format_decimals(vector.z(), decimals));
}

std::string clock_text(double seconds) {
  if (seconds < 10) return format_number(seconds, 2) + "\u00a0s";
  const long whole = std::lround(seconds);
  char text[64];
  if (whole < 60)
    std::snprintf(text, sizeof text, "%ld\u00a0s", whole);
  else if (whole < 3600)
    std::snprintf(text, sizeof text, "%ld\u00a0min %02ld\u00a0s", whole / 60, whole % 60);
  else
    std::snprintf(text, sizeof text, "%ld\u00a0h %02ld\u00a0min", whole / 3600, whole / 60 % 60);
  return text;
}

}  // namespace talus::report
