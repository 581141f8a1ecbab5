#include "model/tolerance_text.hpp"

#include <charconv>

#include "model/number_text.hpp"
#include "model/solver_settings.hpp"

namespace talus {

std::string tolerance_text(double tolerance) {
  for (const auto& [name, value] : named_tolerances)
    if (tolerance == value) return std::string(name);
  return number_text(tolerance);
}

std::optional<double> tolerance_from(const std::string& text) {
  for (const auto& [name, value] : named_tolerances)
    if (text == name) return value;
  double number = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool all_read = problem == std::errc() && end == text.data() + text.size();
  return all_read && is_tolerance(number) ? std::optional(number) : std::nullopt;
}

}  // namespace talus
