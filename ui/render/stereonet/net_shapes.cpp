#include "render/stereonet/net_shapes.hpp"

#include <cmath>
#include <numbers>

namespace talus {
namespace {

std::vector<Vec2> regular(int corners, double radius, double first_degrees) {
  std::vector<Vec2> outline;
  for (int i = 0; i < corners; ++i) {
    const double angle = first_degrees * std::numbers::pi / 180 + 2 * std::numbers::pi * i / corners;
    outline.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return outline;
}

}  // namespace

std::vector<std::vector<Vec2>> symbol_outline(NetSymbol symbol) {
  // Radii that make the symbols look equally large.
  switch (symbol) {
    case NetSymbol::square:
      return {regular(4, 1.2, 45)};
    case NetSymbol::triangle:
      return {regular(3, 1.35, 90)};
    case NetSymbol::diamond:
      return {regular(4, 1.3, 0)};
    case NetSymbol::inverted_triangle:
      return {regular(3, 1.35, -90)};
    case NetSymbol::cross: {
      constexpr double arm = 1.2, half = 0.32;
      return {{{-arm, -half}, {arm, -half}, {arm, half}, {-arm, half}},
              {{-half, -arm}, {half, -arm}, {half, arm}, {-half, arm}}};
    }
    case NetSymbol::disc:
      break;
  }
  return {regular(24, 1, 0)};
}

}  // namespace talus
