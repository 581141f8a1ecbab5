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
    const std::size_t i =
        (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) * 3;
    return {rgb[i], rgb[i + 1], rgb[i + 2]};
  }
};

/// Throws InputError when the file cannot be written; nothing half-written is left.
void write_png(const Image& image, const std::filesystem::path& path);

/// The bytes of a PNG file.
std::string png_of(const Image& image);

/// Throws InputError when the file is no readable PNG.
Image read_png(const std::filesystem::path& path);

}  // namespace talus
