#pragma once

#include <string>

#include "base/vector.hpp"

/// Numbers of a report as people read them.
namespace talus::report {

/// "2.35 m", "12.4 mm": a value of an SI unit under the prefix that suits it.
std::string quantity(double value, const std::string& si_unit, int significant = 3);

/// A prefix for values up to `magnitude`: "MJ" and what J are multiplied by; "kN", "m", "MPa" likewise.
struct Prefixed {
  std::string unit;
  double factor = 1;
};
Prefixed prefixed(const std::string& si_unit, double magnitude);

/// "2600", "0.14": a number that was given, without zeros that say nothing, to six digits.
std::string given(double value);

/// "3.5 %", "0.012 %"; of a share.
std::string percent(double share, int significant = 2);

/// Digits after the point that show values up to `largest` to `significant` digits, 0 to 6: for columns.
int decimals_for(double largest, int significant = 4);

/// "(1.25, 3, −0.4)", of numbers that were given; on one line.
std::string given(const Vec3& vector);

/// "(1.25, 3.00, −0.40)", each of so many digits after the point, on one line.
std::string vector_text(const Vec3& vector, int decimals);

/// Seconds of a clock: "0.42 s", "12 s", "3 min 20 s", "2 h 05 min".
std::string clock_text(double seconds);

}  // namespace talus::report
