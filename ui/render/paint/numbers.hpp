#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace talus {

/// A number for people: `significant` figures, a thin space every three digits from 10 000 on, the true minus sign,
/// powers of ten below 10⁻⁴ and from 10⁷ on. What is not finite is "–".
std::string format_number(double value, int significant = 3);

/// The same with a fixed number of decimals.
std::string format_decimals(double value, int decimals);

/// "10⁻⁴".
std::string power_of_ten_text(int exponent);

/// Multiples of 1, 2 or 5 · 10ᵏ within [low, high], at most `most` (≥ 2) of them. low < high.
std::vector<double> nice_ticks(double low, double high, int most);

/// Labels with as many decimals as the step between the ticks asks for.
std::vector<std::string> tick_labels(const std::vector<double>& ticks);

/// The smallest of 1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8 · 10ᵏ that is not below `value` > 0: the end of a scale.
double round_up(double value);

/// The largest of 1, 2, 5 · 10ᵏ that is not above `value` > 0: the length of a scale bar.
double round_down(double value);

/// What values of an SI unit are shown in: value · factor has the unit `name`.
struct DisplayUnit {
  std::string name;
  double factor = 1;
};

/// Prefix for values up to `magnitude` (SI): Pa, kPa, MPa or GPa; N, kN … TN, and J likewise; µm, mm or m;
/// other units stay.
DisplayUnit display_unit(std::string_view si_unit, double magnitude);

}  // namespace talus
