#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace talus {

/// JSON whose objects keep their keys in the order of the file.
using OrderedJson = nlohmann::ordered_json;

/// Where one value of a JSON text stands: offsets into the text.
struct JsonSpan {
  std::string key;                 ///< of an object's member; empty for elements and the root
  std::size_t start = 0;           ///< of the key's opening quote, or of the value when it has no key
  std::size_t begin = 0, end = 0;  ///< of the value
  std::vector<JsonSpan> children;  ///< of objects and arrays, in the order of the text
};

/// A JSON text with comments, its value, and where each part of it stands.
struct JsonText {
  std::string text;
  OrderedJson value;
  JsonSpan root;
};

/// Parses JSON with // and /* */ comments. Throws InputError with line and column for what is not JSON (also for
/// NaN, Infinity and numbers outside a double's range), for a key given twice, and for nesting deeper than 64.
JsonText parse_json_text(std::string text);

/// The first offset at or after `offset` that is neither white space nor comment.
std::size_t skip_white_space_and_comments(const std::string& text, std::size_t offset);

/// "line 12", counted from 1.
std::string line_text(const std::string& text, std::size_t offset);

/// Where the place that a JSON pointer names begins in the text (a member at its key), or the nearest thing around it.
std::size_t offset_in_text(const JsonText& json, const std::string& pointer);

/// "line 12, /materials/rock/density": the line of the place that the JSON pointer names, or of the nearest thing
/// around it that is in the text.
std::string place_in_text(const JsonText& json, const std::string& pointer);

}  // namespace talus
