#pragma once

#include <string>

namespace talus {

/// The shortest decimal text that reads back as the same double: "2600", "2.5e10", "-0.0".
/// JSON has no other spelling for a negative zero than one with a point. The number must be finite to be JSON;
/// others come out as "nan", "inf" and "-inf", for messages.
std::string number_text(double value);

/// A count for people: 1240 as "1 240".
std::string count_text(long count);

}  // namespace talus
