#pragma once

#include <string>

namespace talus {

/// The shortest decimal text that reads back as the same double: "2600", "2.5e10", "-0.0".
/// JSON has no other spelling for a negative zero than one with a point. The number must be finite to be JSON;
/// others come out as "nan", "inf" and "-inf", for messages.
std::string number_text(double value);

/// A number to so many significant digits: "3.25e-07".
std::string significant(double value, int digits = 3);

/// A fixed number of digits after the point, never "-0.00": "26.50".
std::string decimals(double value, int digits);

/// A count for people: 1240 as "1 240".
std::string count_text(long count);
/// "1 step", "1 240 steps".
std::string counted_text(long count, const char* one, const char* many);

}  // namespace talus
