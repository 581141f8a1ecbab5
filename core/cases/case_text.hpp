#pragma once

#include <string>

#include "base/vector.hpp"

/// Numbers as the tables of the known cases print them.
namespace talus {

/// "26.50": a fixed number of digits after the point, never "-0.00".
std::string decimals(double value, int digits);

/// "3.25e-07": a number to so many significant digits.
std::string significant(double value, int digits = 3);

/// "(0.45, 0.63, -0.63)", or "–" for a zero vector.
std::string direction_text(const Vec3& direction);

}  // namespace talus
