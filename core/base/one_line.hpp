#pragma once

#include <string>

namespace talus {

/// One line that a person reads, whatever a file or a library put into its message: no control characters, and of a
/// long one the beginning, which says where, and the end, which says what to do; at most 480 bytes.
std::string one_line(std::string message);

}  // namespace talus
