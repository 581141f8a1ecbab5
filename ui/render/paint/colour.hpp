#pragma once

#include <cstdint>

namespace talus {

/// A colour as screens have it (sRGB), 0…255.
struct Rgb {
  std::uint8_t red = 0, green = 0, blue = 0;
  bool operator==(const Rgb&) const = default;
};

/// `share` of `b` in `a`, 0…1.
Rgb mix(Rgb a, Rgb b, double share);

/// 0xRRGGBB
constexpr Rgb rgb(unsigned hex) {
  return {static_cast<std::uint8_t>(hex >> 16), static_cast<std::uint8_t>(hex >> 8), static_cast<std::uint8_t>(hex)};
}

}  // namespace talus
