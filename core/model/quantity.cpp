#include "model/quantity.hpp"

#include <cmath>
#include <utility>

namespace talus {
namespace {

using Field = Quantity::Field;
using Component = Quantity::Component;

constexpr std::pair<std::string_view, Field> fields[] = {
    {"displacement", Field::displacement}, {"velocity", Field::velocity}, {"stress", Field::stress}};
constexpr std::pair<std::string_view, Component> components[] = {
    {"x", Component::x},   {"y", Component::y},   {"z", Component::z},   {"magnitude", Component::magnitude},
    {"xx", Component::xx}, {"yy", Component::yy}, {"zz", Component::zz}, {"xy", Component::xy},
    {"yz", Component::yz}, {"zx", Component::zx}};

template <class Words>
auto meaning(const Words& words, std::string_view word) {
  for (const auto& [text, what] : words)
    if (text == word) return std::optional(what);
  return decltype(std::optional(words[0].second))();
}

}  // namespace

std::optional<Quantity> parse_quantity(const std::string& text) {
  const auto last_dot = text.rfind('.');
  if (last_dot == std::string::npos || last_dot == 0) return std::nullopt;
  const auto first_dot = text.rfind('.', last_dot - 1);
  if (first_dot == std::string::npos || first_dot == 0) return std::nullopt;

  const auto field = meaning(fields, text.substr(first_dot + 1, last_dot - first_dot - 1));
  const auto component = meaning(components, text.substr(last_dot + 1));
  if (!field || !component) return std::nullopt;
  if ((*field == Field::stress) != (*component >= Component::xx)) return std::nullopt;
  return Quantity{text.substr(0, first_dot), *field, *component};
}

std::string_view unit_of(Field field) {
  switch (field) {
    case Field::velocity:
      return "m/s";
    case Field::stress:
      return "Pa";
    case Field::displacement:
      break;
  }
  return "m";
}

double similar(Field field, double scale) { return field == Field::velocity ? std::sqrt(scale) : scale; }

}  // namespace talus
