#include "render/paint/colour.hpp"

#include <cmath>

namespace talus {

Rgb mix(Rgb a, Rgb b, double share) {
  const auto channel = [share](std::uint8_t from, std::uint8_t to) {
    return static_cast<std::uint8_t>(std::lround(from + (to - from) * share));
  };
  return {channel(a.red, b.red), channel(a.green, b.green), channel(a.blue, b.blue)};
}

}  // namespace talus
