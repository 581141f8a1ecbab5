#include "study/accuracy/choice.hpp"

#include <cmath>

#include "base/error.hpp"

namespace talus {

std::vector<bool> pareto_front(std::span<const std::optional<CostAndError>> offers) {
  const auto beats = [](const CostAndError& a, const CostAndError& b) {
    return a.seconds <= b.seconds && a.error <= b.error && (a.seconds < b.seconds || a.error < b.error);
  };
  std::vector<bool> front;
  for (const auto& offer : offers) {
    bool best = offer.has_value();
    for (const auto& other : offers) best = best && !(other && beats(*other, *offer));
    front.push_back(best);
  }
  return front;
}

int cheapest_within(double target, std::span<const std::optional<CostAndError>> offers) {
  int best = -1;
  for (std::size_t i = 0; i < offers.size(); ++i) {
    if (!offers[i] || offers[i]->error > target) continue;
    if (best < 0 || offers[i]->seconds < offers[static_cast<std::size_t>(best)]->seconds) best = static_cast<int>(i);
  }
  return best;
}

double parse_target(const std::string& text) {
  std::size_t end = 0;
  double value = 0;
  try {
    value = std::stod(text, &end);
  } catch (const std::exception&) {
    end = 0;
  }
  const std::string rest = text.substr(end);
  const bool percent = rest == "%" || rest == " %";
  if (end == 0 || !(rest.empty() || percent) || !std::isfinite(value) || value <= 0)
    throw InputError("target '" + text + "'", "is no error to aim at", "write a share above 0, like 1% or 0.01");
  return percent ? value / 100 : value;
}

}  // namespace talus
