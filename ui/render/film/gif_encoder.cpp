#include <fcntl.h>
#include <gif_lib.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "render/film/movie_encoder.hpp"

namespace talus {
namespace {

constexpr int palette_size = 256;
constexpr int levels = 64;  ///< of each channel, in the table from colours to palette entries

class GifEncoder final : public MovieEncoder {
 public:
  GifEncoder(const std::filesystem::path& path, int width, int height, int fps)
      : width_(width), height_(height), hundredths_(std::max(2, (100 + fps / 2) / fps)) {
    int error = 0;
    // Giflib's own way of opening makes files that only their owner can read.
    const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    if (file < 0)
      throw std::runtime_error(std::string("the film cannot be opened for writing: ") + std::strerror(errno));
    gif_ = EGifOpenFileHandle(file, &error);
    if (!gif_) close(file);
    if (!gif_) throw std::runtime_error(message(error));
    EGifSetGifVersion(gif_, true);
    check(EGifPutScreenDesc(gif_, width, height, 8, 0, nullptr));
    constexpr unsigned char for_ever[] = {1, 0, 0};
    check(EGifPutExtensionLeader(gif_, APPLICATION_EXT_FUNC_CODE));
    check(EGifPutExtensionBlock(gif_, 11, "NETSCAPE2.0"));
    check(EGifPutExtensionBlock(gif_, 3, for_ever));
    check(EGifPutExtensionTrailer(gif_));
  }
  ~GifEncoder() override {
    int error = 0;
    if (gif_) EGifCloseFile(gif_, &error);
  }
  GifEncoder(const GifEncoder&) = delete;
  GifEncoder& operator=(const GifEncoder&) = delete;

  void add(const Image& image) override {
    make_palette(image);
    GraphicsControlBlock control{DISPOSE_DO_NOT, false, hundredths_, NO_TRANSPARENT_COLOR};
    GifByteType extension[4];
    EGifGCBToExtension(&control, extension);
    check(EGifPutExtension(gif_, GRAPHICS_EXT_FUNC_CODE, 4, extension));
    ColorMapObject* map = GifMakeMapObject(palette_size, palette_.data());
    const int outcome = EGifPutImageDesc(gif_, 0, 0, width_, height_, false, map);
    GifFreeMapObject(map);
    check(outcome);
    std::vector<GifPixelType> row(static_cast<std::size_t>(width_));
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) row[static_cast<std::size_t>(x)] = nearest_entry(dithered(image.at(x, y), x, y));
      check(EGifPutLine(gif_, row.data(), width_));
    }
  }

  void finish() override {
    int error = 0;
    GifFileType* closed = gif_;
    gif_ = nullptr;
    if (EGifCloseFile(closed, &error) != GIF_OK) throw std::runtime_error(message(error));
  }

 private:
  static std::string message(int error) {
    const char* text = GifErrorString(error);
    return std::string("writing the GIF: ") + (text ? text : "failed");
  }
  void check(int outcome) const {
    if (outcome != GIF_OK) throw std::runtime_error(message(gif_->Error));
  }
  static std::size_t cell(Rgb c) {
    const auto level = [](std::uint8_t channel) { return static_cast<std::size_t>(channel) * levels / 256; };
    return (level(c.red) * levels + level(c.green)) * levels + level(c.blue);
  }

  /// Giflib's median cut of each picture: a slide shows colours late that its first picture does not have.
  void make_palette(const Image& image) {
    const std::size_t count = image.rgb.size() / 3;
    std::vector<GifByteType> red(count), green(count), blue(count), indices(count);
    for (std::size_t i = 0; i < count; ++i) {
      red[i] = image.rgb[3 * i];
      green[i] = image.rgb[3 * i + 1];
      blue[i] = image.rgb[3 * i + 2];
    }
    int size = palette_size;
    if (GifQuantizeBuffer(static_cast<unsigned>(width_), static_cast<unsigned>(height_), &size, red.data(),
                          green.data(), blue.data(), indices.data(), palette_.data()) != GIF_OK)
      throw std::runtime_error("writing the GIF: colours cannot be reduced");
    std::fill(nearest_.begin(), nearest_.end(), unknown);
  }

  /// Bayer's 4 × 4 pattern: a soft background shows no bands, and the pattern stands still from picture to picture.
  static Rgb dithered(Rgb c, int x, int y) {
    static constexpr int pattern[4][4] = {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};
    const int shift = pattern[y % 4][x % 4] / 2 - 4;  // half the 8 of 255 between the steps of giflib's median cut
    const auto moved = [shift](std::uint8_t channel) {
      return static_cast<std::uint8_t>(std::clamp(channel + shift, 0, 255));
    };
    return {moved(c.red), moved(c.green), moved(c.blue)};
  }

  GifPixelType nearest_entry(Rgb colour) {
    std::int16_t& known = nearest_[cell(colour)];
    if (known != unknown) return static_cast<GifPixelType>(known);
    int least = std::numeric_limits<int>::max();
    for (int i = 0; i < palette_size; ++i) {
      const GifColorType& c = palette_[static_cast<std::size_t>(i)];
      const int dr = colour.red - c.Red, dg = colour.green - c.Green, db = colour.blue - c.Blue;
      const int distance = 2 * dr * dr + 4 * dg * dg + db * db;  // the eye sees green best
      if (distance >= least) continue;
      least = distance;
      known = static_cast<std::int16_t>(i);
    }
    return static_cast<GifPixelType>(known);
  }

  static constexpr std::int16_t unknown = -1;
  int width_, height_, hundredths_;
  GifFileType* gif_ = nullptr;
  std::array<GifColorType, palette_size> palette_{};
  std::vector<std::int16_t> nearest_ =
      std::vector<std::int16_t>(levels * levels * levels);  ///< a colour: its entry, once asked for
};

}  // namespace

std::unique_ptr<MovieEncoder> make_gif_encoder(const std::filesystem::path& path, int width, int height, int fps) {
  return std::make_unique<GifEncoder>(path, width, height, fps);
}

}  // namespace talus
