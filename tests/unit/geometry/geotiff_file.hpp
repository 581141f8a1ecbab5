#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace talus::rock {

/// An uncompressed GeoTIFF of 32-bit heights: the corner of its first cell lies at (x, y).
inline std::string geotiff(int width, int height, double cell, double x, double y, const std::vector<float>& heights) {
  std::string data, entries;
  const auto append = [](std::string& text, const auto& value) {
    text.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  constexpr std::uint16_t count = 13, ascii = 2, two_bytes = 3, four_bytes = 4, real = 12;
  constexpr std::uint32_t data_begins = 8 + 2 + 12 * count + 4;
  const auto entry = [&](std::uint16_t tag, std::uint16_t type, std::uint32_t values, std::uint32_t value) {
    append(entries, tag);
    append(entries, type);
    append(entries, values);
    append(entries, value);
  };
  const auto place_now = [&] { return data_begins + static_cast<std::uint32_t>(data.size()); };
  const std::uint32_t heights_at = place_now();
  for (const float value : heights) append(data, value);
  const std::uint32_t cell_at = place_now();
  for (const double value : {cell, cell, 0.0}) append(data, value);
  const std::uint32_t tie_at = place_now();
  for (const double value : {0.0, 0.0, 0.0, x, y, 0.0}) append(data, value);
  const std::uint32_t no_data_at = place_now();
  data += std::string("-9999\0", 6);
  const auto bytes = static_cast<std::uint32_t>(4 * heights.size());
  entry(256, four_bytes, 1, static_cast<std::uint32_t>(width));
  entry(257, four_bytes, 1, static_cast<std::uint32_t>(height));
  entry(258, two_bytes, 1, 32);  // bits
  entry(259, two_bytes, 1, 1);   // not compressed
  entry(262, two_bytes, 1, 1);   // black is zero
  entry(273, four_bytes, 1, heights_at);
  entry(277, two_bytes, 1, 1);  // a sample a cell
  entry(278, four_bytes, 1, static_cast<std::uint32_t>(height));
  entry(279, four_bytes, 1, bytes);
  entry(339, two_bytes, 1, 3);  // floating point
  entry(33550, real, 3, cell_at);
  entry(33922, real, 6, tie_at);
  entry(42113, ascii, 6, no_data_at);  // GDAL's
  std::string file("II*\0", 4);
  append(file, std::uint32_t{8});
  append(file, count);
  file += entries;
  append(file, std::uint32_t{0});
  return file + data;
}

}  // namespace talus::rock
