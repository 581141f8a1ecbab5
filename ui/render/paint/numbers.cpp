#include "render/paint/numbers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <utility>

namespace talus {
namespace {

constexpr std::string_view minus = "\u2212", thin_space = "\u2009", missing = "\u2013", times_ten = "\u00d710";

std::string printed(double value, int decimals) {
  std::array<char, 400> text;
  const int length = std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  return std::string(text.data(), static_cast<std::size_t>(length));
}

/// "12345.678" → "12 345.678", only from five digits on.
std::string grouped(const std::string& digits) {
  const std::size_t whole = std::min(digits.find('.'), digits.size());
  if (whole < 5) return digits;
  std::string out;
  for (std::size_t i = 0; i < whole; ++i) {
    if (i > 0 && (whole - i) % 3 == 0) out += thin_space;
    out += digits[i];
  }
  return out + digits.substr(whole);
}

std::string superscript(int exponent) {
  static constexpr std::array<std::string_view, 10> digits{"\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074",
                                                           "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
  std::string out = exponent < 0 ? "\u207b" : "";
  for (const char digit : std::to_string(std::abs(exponent))) out += digits[static_cast<std::size_t>(digit - '0')];
  return out;
}

/// Power of ten of a number after rounding to `significant` figures: 999.7 to three is 1000, hence 3.
int exponent_of(double magnitude, int significant) {
  std::array<char, 64> text;
  std::snprintf(text.data(), text.size(), "%.*e", significant - 1, magnitude);
  const std::string_view written(text.data());
  return std::stoi(std::string(written.substr(written.find('e') + 1)));
}

double power_of_ten(double value) { return std::pow(10.0, std::floor(std::log10(value) + 1e-12)); }

constexpr double slack = 1e-9;  ///< relative: 0.3/0.1 counts as 3

}  // namespace

std::string power_of_ten_text(int exponent) { return "10" + superscript(exponent); }

std::string format_decimals(double value, int decimals) {
  if (!std::isfinite(value)) return std::string(missing);
  const std::string digits = printed(std::abs(value), decimals);
  const bool zero = digits.find_first_of("123456789") == std::string::npos;
  return std::string(std::signbit(value) && !zero ? minus : "") + grouped(digits);
}

std::string format_number(double value, int significant) {
  if (!std::isfinite(value)) return std::string(missing);
  if (value == 0) return "0";
  const int exponent = exponent_of(std::abs(value), significant);
  if (exponent < -4 || exponent >= 7) {
    const double mantissa = value / std::pow(10.0, exponent);
    return format_decimals(mantissa, significant - 1) + std::string(times_ten) + superscript(exponent);
  }
  const int decimals = significant - 1 - exponent;
  if (decimals >= 0) return format_decimals(value, decimals);
  const double unit = std::pow(10.0, -decimals);
  return format_decimals(std::round(value / unit) * unit, 0);
}

std::vector<double> nice_ticks(double low, double high, int most) {
  const double length = high - low;
  double step = power_of_ten(length / std::max(most - 1, 1));
  const auto count = [&](double by) { return std::floor(high / by + slack) - std::ceil(low / by - slack) + 1; };
  for (int i = 0; count(step) > most; ++i) step *= i % 3 == 1 ? 2.5 : 2;  // 1, 2, 5, 10, …
  std::vector<double> ticks;
  const auto first = static_cast<long>(std::ceil(low / step - slack));
  const auto last = static_cast<long>(std::floor(high / step + slack));
  for (long i = first; i <= last; ++i) ticks.push_back(static_cast<double>(i) * step);
  return ticks;
}

std::vector<std::string> tick_labels(const std::vector<double>& ticks) {
  std::vector<std::string> labels;
  if (ticks.size() < 2) {
    for (const double tick : ticks) labels.push_back(format_number(tick));
    return labels;
  }
  const double step = ticks[1] - ticks[0];
  const double largest = std::max(std::abs(ticks.front()), std::abs(ticks.back()));
  const bool powers = largest >= 1e7 || largest < 1e-3;
  const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + slack)));
  for (const double tick : ticks) labels.push_back(powers ? format_number(tick) : format_decimals(tick, decimals));
  return labels;
}

double round_up(double value) {
  static constexpr std::array<double, 11> steps{1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10};
  const double power = power_of_ten(value);
  const auto fits = [&](double step) { return step * power >= value * (1 - slack); };
  return *std::find_if(steps.begin(), steps.end(), fits) * power;
}

double round_down(double value) {
  const double power = power_of_ten(value);
  const double mantissa = value / power * (1 + slack);
  return (mantissa >= 5 ? 5 : mantissa >= 2 ? 2 : 1) * power;
}

DisplayUnit display_unit(std::string_view si_unit, double magnitude) {
  const double size = std::abs(magnitude);
  if (si_unit == "Pa") {
    if (size >= 1e10) return {"GPa", 1e-9};
    if (size >= 1e5) return {"MPa", 1e-6};
    if (size >= 1e2) return {"kPa", 1e-3};
  }
  if (si_unit == "N" || si_unit == "J")
    for (const auto& [prefix, least] :
         {std::pair("T", 1e12), std::pair("G", 1e9), std::pair("M", 1e6), std::pair("k", 1e3)})
      if (size >= least) return {prefix + std::string(si_unit), 1 / least};
  if ((si_unit == "m" || si_unit == "m/s") && size > 0) {
    const std::string rest(si_unit.substr(1));
    if (size < 1e-5) return {"\u00b5m" + rest, 1e6};
    if (size < 1e-2) return {"mm" + rest, 1e3};
  }
  return {std::string(si_unit), 1};
}

}  // namespace talus
