#pragma once

#include <string>
#include <string_view>

#include "io/json_text.hpp"

namespace talus {

/// How a JSON text is laid out where Talus writes it.
struct JsonLayout {
  std::string_view newline = "\n";
  std::size_t step = 2;     ///< spaces a level
  std::size_t width = 100;  ///< what fits into this many columns stands on one line
};

/// The value as text: numbers in their shortest form that reads back the same, short objects and lists on one line.
/// `indent`: spaces in front of the line it begins on; that line itself is not indented. `apart`: a member a line, even
/// where all would fit into one.
/// Throws InputError when a number is not finite.
std::string format_json(const OrderedJson& value, std::size_t indent, const JsonLayout& layout, bool apart = false);

/// A text in JSON's quotes.
std::string quoted(const std::string& text);

}  // namespace talus
