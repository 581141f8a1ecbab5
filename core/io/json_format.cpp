#include "io/json_format.hpp"

#include <cmath>

#include "base/error.hpp"
#include "model/number_text.hpp"

namespace talus {
namespace {

std::string format_scalar(const OrderedJson& value) {
  if (value.is_string()) return quoted(value.get_ref<const std::string&>());
  if (!value.is_number_float()) return value.dump();
  const auto number = value.get<double>();
  if (!std::isfinite(number)) {
    throw InputError("the project", "holds a number that is not finite", "give finite numbers before saving");
  }
  return number_text(number);
}

std::string one_line(const OrderedJson& value) {
  if (!value.is_structured()) return format_scalar(value);
  std::string inside;
  for (const auto& [key, item] : value.items()) {
    if (!inside.empty()) inside += ", ";
    if (value.is_object()) inside += quoted(key) + ": ";
    inside += one_line(item);
  }
  return value.is_object() ? "{" + inside + "}" : "[" + inside + "]";
}

/// Lists of things (solids, cuts) and things by name (materials) read better with one thing a line.
bool holds_things(const OrderedJson& value) { return !value.empty() && value.front().is_object(); }

}  // namespace

std::string quoted(const std::string& text) {
  return OrderedJson(text).dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
}

std::string format_json(const OrderedJson& value, std::size_t indent, const JsonLayout& layout, bool apart) {
  if (!value.is_structured()) return format_scalar(value);
  if (!holds_things(value) && !apart) {
    std::string line = one_line(value);
    if (indent + line.size() <= layout.width) return line;
  }
  const std::string margin = std::string(layout.newline) + std::string(indent + layout.step, ' ');
  std::string inside;
  for (const auto& [key, item] : value.items()) {
    if (!inside.empty()) inside += ",";
    inside += margin;
    if (value.is_object()) inside += quoted(key) + ": ";
    inside += format_json(item, indent + layout.step, layout);
  }
  inside += layout.newline;
  inside += std::string(indent, ' ');
  return value.is_object() ? "{" + inside + "}" : "[" + inside + "]";
}

}  // namespace talus
