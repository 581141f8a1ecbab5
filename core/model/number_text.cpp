#include "model/number_text.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace talus {

std::string number_text(double value) {
  if (value == 0 && std::signbit(value)) return "-0.0";
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  std::string text(digits.data(), end);
  if (const auto exponent = text.find('e'); exponent != std::string::npos) {
    const std::size_t sign = text[exponent + 1] == '-' ? 1 : 0;
    text.erase(exponent + 1 + sign, text.find_first_not_of("+-0", exponent + 1) - (exponent + 1 + sign));
  }
  return text;
}

std::string significant(double value, int digits) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

std::string decimals(double value, int digits) {
  const double unit = std::pow(10.0, digits);
  if (std::abs(value) * unit < 0.5) value = 0;
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

std::string count_text(long count) {
  std::string text = std::to_string(count);
  const std::size_t first_digit = count < 0 ? 1 : 0;
  for (std::size_t at = text.size(); at > first_digit + 3;) text.insert(at -= 3, " ");
  return text;
}

std::string counted_text(long count, const char* one, const char* many) {
  return count_text(count) + " " + (count == 1 ? one : many);
}

}  // namespace talus
