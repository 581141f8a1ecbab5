#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "render/paint/colour.hpp"

namespace talus {

/// A picture in memory: rows from top to bottom, three bytes a pixel.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;

  Image() = default;
  Image(int w, int h) : width(w), height(h), rgb(static_cast<std::size_t>(w) * static_cast<std::size_t>(h) * 3) {}

  Rgb at(int x, int y) const {
    const std::size_t i = 3 * pixel(x, y);
    return {rgb[i], rgb[i + 1], rgb[i + 2]};
  }
  void set(int x, int y, Rgb colour) {
    const std::size_t i = 3 * pixel(x, y);
    rgb[i] = colour.red;
    rgb[i + 1] = colour.green;
    rgb[i + 2] = colour.blue;
  }
  /// Its number, row by row.
  std::size_t pixel(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
};

/// Throws InputError when the file cannot be written; nothing half-written is left.
void write_png(const Image& image, const std::filesystem::path& path);

/// The bytes of a PNG file.
std::string png_of(const Image& image);

/// Throws InputError when the file is no readable PNG.
Image read_png(const std::filesystem::path& path);

}  // namespace talus
