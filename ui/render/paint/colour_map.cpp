#include "render/paint/colour_map.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

extern const char batlow_table[];
extern const char vik_table[];

namespace talus {
namespace {

ColourMap read_table(const char* text) {
  std::istringstream in(text);
  std::array<Rgb, 256> table;
  for (Rgb& colour : table) {
    double red, green, blue;
    if (!(in >> red >> green >> blue)) throw std::logic_error("a colour map has fewer than 256 rows");
    const auto byte = [](double share) { return static_cast<std::uint8_t>(std::lround(255 * share)); };
    colour = {byte(red), byte(green), byte(blue)};
  }
  return ColourMap(table);
}

}  // namespace

Rgb ColourMap::at(double t) const {
  const double place = std::clamp(t, 0.0, 1.0) * 255;
  const auto below = std::min<std::size_t>(static_cast<std::size_t>(place), 254);
  return mix(table_[below], table_[below + 1], place - static_cast<double>(below));
}

const ColourMap& batlow() {
  static const ColourMap map = read_table(batlow_table);
  return map;
}

const ColourMap& vik() {
  static const ColourMap map = read_table(vik_table);
  return map;
}

}  // namespace talus
