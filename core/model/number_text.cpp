#include "model/number_text.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace talus {

std::string number_text(double value) {
  if (value == 0 && std::signbit(value)) return "-0.0";
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  std::string text(digits.data(), end);
  if (const auto plus = text.find("e+"); plus != std::string::npos) text.erase(plus + 1, 1);
  return text;
}

}  // namespace talus
