#include "render/charts/log_axis.hpp"

#include <algorithm>
#include <cmath>

#include "render/paint/numbers.hpp"

namespace talus {

double LogAxis::share(double value) const { return std::log(value / low) / std::log(high / low); }

LogAxis make_log_axis(const std::vector<double>& values) {
  LogAxis axis;
  if (!values.empty()) {
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    constexpr double least_span = 10;
    const double widen = std::max(1.0, std::sqrt(least_span / (*most / *least)));
    const double room = std::pow(*most / *least * widen * widen, 0.08);
    axis.low = *least / widen / room;
    axis.high = *most * widen * room;
  }
  const double decades = std::log10(axis.high / axis.low);
  const int every = std::max(1, static_cast<int>(std::ceil(decades / 9)));
  for (int power = static_cast<int>(std::floor(std::log10(axis.low))); std::pow(10, power) <= axis.high; ++power)
    for (int digit = 1; digit < 10; ++digit) {
      const double tick = digit * std::pow(10, power);
      if (tick < axis.low || tick > axis.high) continue;
      const bool labelled = digit == 1 ? power % every == 0 : decades < 2.2 && (digit == 2 || digit == 5);
      if (labelled || decades < 5) (labelled ? axis.ticks : axis.lesser_ticks).push_back(tick);
    }
  return axis;
}

std::string error_text(double error) {
  constexpr double percent = 100, plain_from = 0.001;
  const double value = percent * error;
  // Below a thousandth zeros would have to be counted.
  if (value == 0 || value >= plain_from) return format_number(value, 2) + " %";
  const int power = static_cast<int>(std::floor(std::log10(value)));
  return format_number(value * std::pow(10, -power), 2) + "×" + power_of_ten_text(power) + " %";
}

std::string error_tick_text(double tick) {
  constexpr double percent = 100, plain_from = 0.000999;
  const double value = percent * tick;
  if (value >= plain_from) return tick_text(value) + " %";
  const int power = static_cast<int>(std::floor(std::log10(value) + 1e-9));
  const std::string digit = format_number(std::round(value * std::pow(10, -power)), 1);
  return (digit == "1" ? "" : digit + "×") + power_of_ten_text(power) + " %";
}

std::string tick_text(double tick) { return format_number(tick, 1); }

}  // namespace talus
