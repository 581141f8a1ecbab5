#pragma once

#include <string>

namespace talus::cli {

/// `text` broken into lines of 110 characters at spaces, each after `indent` spaces.
std::string paragraph(const std::string& text, std::size_t indent);

}  // namespace talus::cli
