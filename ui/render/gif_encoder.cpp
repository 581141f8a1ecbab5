#include <gif_lib.h>

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "render/movie_encoder.hpp"

namespace talus {
namespace {

constexpr int palette_size = 256;
constexpr int levels = 32;  ///< of each channel, in the table from colours to palette entries

class GifEncoder final : public MovieEncoder {
 public:
  GifEncoder(const std::filesystem::path& path, int width, int height, int fps)
      : width_(width), height_(height), hundredths_(std::max(2, (100 + fps / 2) / fps)) {
    int error = 0;
    gif_ = EGifOpenFileName(path.c_str(), false, &error);
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
      for (int x = 0; x < width_; ++x) row[static_cast<std::size_t>(x)] = nearest_[cell(image.at(x, y))];
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
    for (int r = 0; r < levels; ++r)
      for (int g = 0; g < levels; ++g)
        for (int b = 0; b < levels; ++b)
          nearest_[(static_cast<std::size_t>(r) * levels + g) * levels + b] = nearest_entry(r, g, b, size);
  }

  GifPixelType nearest_entry(int r, int g, int b, int size) const {
    const auto middle = [](int level) { return (2 * level + 1) * 256 / (2 * levels); };
    int best = 0, least = std::numeric_limits<int>::max();
    for (int i = 0; i < size; ++i) {
      const GifColorType& c = palette_[static_cast<std::size_t>(i)];
      const int dr = middle(r) - c.Red, dg = middle(g) - c.Green, db = middle(b) - c.Blue;
      const int distance = 2 * dr * dr + 4 * dg * dg + db * db;  // the eye sees green best
      if (distance < least) least = distance, best = i;
    }
    return static_cast<GifPixelType>(best);
  }

  int width_, height_, hundredths_;
  GifFileType* gif_ = nullptr;
  std::array<GifColorType, palette_size> palette_{};
  std::array<GifPixelType, levels * levels * levels> nearest_{};
};

}  // namespace

std::unique_ptr<MovieEncoder> make_gif_encoder(const std::filesystem::path& path, int width, int height, int fps) {
  return std::make_unique<GifEncoder>(path, width, height, fps);
}

}  // namespace talus
