#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

/// What is chosen among runs of known cost and error.
namespace talus {

struct CostAndError {
  double seconds = 0;
  double error = 0;  ///< relative; with its uncertainty where a choice must hold
};

/// Whether nothing that costs no more has less error, of each; `offers` without a value take no part.
std::vector<bool> pareto_front(std::span<const std::optional<CostAndError>> offers);

/// The cheapest whose error is within the target; −1: none is.
int cheapest_within(double target, std::span<const std::optional<CostAndError>> offers);

/// "1%", "1 %" or "0.01" as 0.01. Throws InputError for what is neither, or not above zero.
double parse_target(const std::string& text);

}  // namespace talus
