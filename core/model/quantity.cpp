#include "model/quantity.hpp"

namespace talus {

std::optional<Quantity> parse_quantity(const std::string& text) {
  const auto last_dot = text.rfind('.');
  if (last_dot == std::string::npos || last_dot == 0) return std::nullopt;
  const auto first_dot = text.rfind('.', last_dot - 1);
  if (first_dot == std::string::npos || first_dot == 0) return std::nullopt;

  const std::string field = text.substr(first_dot + 1, last_dot - first_dot - 1);
  const std::string component = text.substr(last_dot + 1);
  Quantity quantity;
  quantity.of = text.substr(0, first_dot);

  if (field == "displacement")
    quantity.field = Quantity::Field::displacement;
  else if (field == "velocity")
    quantity.field = Quantity::Field::velocity;
  else
    return std::nullopt;

  if (component == "x")
    quantity.component = Quantity::Component::x;
  else if (component == "y")
    quantity.component = Quantity::Component::y;
  else if (component == "z")
    quantity.component = Quantity::Component::z;
  else if (component == "magnitude")
    quantity.component = Quantity::Component::magnitude;
  else
    return std::nullopt;
  return quantity;
}

}  // namespace talus
