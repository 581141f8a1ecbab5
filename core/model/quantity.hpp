#pragma once

#include <optional>
#include <string>

namespace talus {

/// What an expectation compares: "P1.displacement.z", "B2.velocity.magnitude".
struct Quantity {
  enum class Field { displacement, velocity };  ///< m, m/s
  enum class Component { x, y, z, magnitude };

  std::string of;  ///< a monitor, or a block (its centroid); a monitor goes before a block of the same name
  Field field = Field::displacement;
  Component component = Component::x;
};

/// Nothing when the text is not `<name>.<displacement|velocity>.<x|y|z|magnitude>`. The name may hold dots
/// ("slope.2").
std::optional<Quantity> parse_quantity(const std::string& text);

}  // namespace talus
