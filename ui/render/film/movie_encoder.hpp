#pragma once

#include <filesystem>
#include <memory>

#include "render/paint/image.hpp"

namespace talus {

/// One film format. Errors are std::runtime_error with the library's own words.
class MovieEncoder {
 public:
  virtual ~MovieEncoder() = default;
  virtual void add(const Image& image) = 0;
  virtual void finish() = 0;
};

/// H.264 (MPEG-4 part 2 where x264 is not installed) in an mp4 file. `width` and `height` are even.
std::unique_ptr<MovieEncoder> make_mp4_encoder(const std::filesystem::path& path, int width, int height, int fps);

/// A looping GIF, a palette of 256 colours for each picture.
std::unique_ptr<MovieEncoder> make_gif_encoder(const std::filesystem::path& path, int width, int height, int fps);

}  // namespace talus
