#include "render/paint/image.hpp"

#include <png.h>

#include <cstdio>
#include <cstring>
#include <stdexcept>

#include "base/error.hpp"

namespace talus {

namespace {

png_image description_of(const Image& image) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  png.format = PNG_FORMAT_RGB;
  return png;
}

}  // namespace

void write_png(const Image& image, const std::filesystem::path& path) {
  if (path.extension() != ".png" && path.extension() != ".PNG")
    throw InputError(path.string(), "pictures are written as PNG", "let the name end in .png");
  png_image png = description_of(image);
  const int row = image.width * 3;
  if (png_image_write_to_file(&png, path.c_str(), 0, image.rgb.data(), row, nullptr) == 0) {
    std::error_code ignored;
    if (std::filesystem::is_regular_file(path, ignored)) std::filesystem::remove(path, ignored);
    throw InputError(path.string(), std::string("the picture cannot be written: ") + png.message,
                     "choose a folder that exists, is writable and has space");
  }
}

std::string png_of(const Image& image) {
  png_image png = description_of(image);
  const int row = image.width * 3;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&png, bytes.data(), &size, 0, image.rgb.data(), row, nullptr) == 0)
    throw std::runtime_error(std::string("a picture cannot be made a PNG: ") + png.message);
  bytes.resize(size);
  return bytes;
}

Image read_png(const std::filesystem::path& path) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  const auto fail = [&] {
    const std::string why = png.message;
    png_image_free(&png);
    throw InputError(path.string(), "no readable PNG: " + why, "give a PNG file");
  };
  if (png_image_begin_read_from_file(&png, path.c_str()) == 0) fail();
  png.format = PNG_FORMAT_RGB;
  Image image(static_cast<int>(png.width), static_cast<int>(png.height));
  if (png_image_finish_read(&png, nullptr, image.rgb.data(), 0, nullptr) == 0) fail();
  return image;
}

}  // namespace talus
