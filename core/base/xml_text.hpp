#pragma once

#include <string>

namespace talus {

/// Text with the characters that XML gives a meaning written as entities; control characters become spaces.
std::string xml_text(const std::string& text);

}  // namespace talus
