#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace talus {

/// What an expectation compares: "P1.displacement.z", "B2.velocity.magnitude", "P1.stress.zz".
struct Quantity {
  enum class Field { displacement, velocity, stress };
  enum class Component { x, y, z, magnitude, xx, yy, zz, xy, yz, zx };  ///< the six are a stress's

  std::string of;  ///< a monitor, or a block (its centroid); a monitor goes before a block of the same name
  Field field = Field::displacement;
  Component component = Component::x;
};

/// Nothing when the text is neither `<name>.<displacement|velocity>.<x|y|z|magnitude>` nor
/// `<name>.stress.<xx|yy|zz|xy|yz|zx>`. The name may hold dots ("slope.2").
std::optional<Quantity> parse_quantity(const std::string& text);

/// "m", "m/s" or "Pa".
std::string_view unit_of(Quantity::Field field);

/// How the field grows with a model's lengths when it behaves alike (Froude's and Cauchy's similarity): displacements
/// and stresses with `scale`, velocities with its root.
double similar(Quantity::Field field, double scale);

}  // namespace talus
