#pragma once

#include <string>

namespace talus {

/// A count that is known roughly, in two digits, for people: "49 000", "4.8e7".
std::string about_text(double count);

}  // namespace talus
