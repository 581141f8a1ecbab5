#pragma once

#include <array>

#include "render/paint/colour.hpp"

namespace talus {

/// 256 colours from low to high: Fabio Crameri's Scientific colour maps 8.0 (resources/colour_maps).
class ColourMap {
 public:
  explicit ColourMap(const std::array<Rgb, 256>& table) : table_(table) {}
  /// Colour at 0…1, clamped, between neighbouring entries linear.
  Rgb at(double t) const;
  const std::array<Rgb, 256>& table() const { return table_; }

 private:
  std::array<Rgb, 256> table_;
};

/// Dark blue over green to pink: magnitudes.
const ColourMap& batlow();
/// Blue over white to red: signed values, zero in the middle.
const ColourMap& vik();

}  // namespace talus
