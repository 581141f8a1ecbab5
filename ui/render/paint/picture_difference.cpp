#include "render/paint/picture_difference.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace talus {

namespace {

// Structural similarity: Wang, Bovik, Sheikh and Simoncelli (2004), Image quality assessment: from error visibility to
// structural similarity, IEEE Transactions on Image Processing 13(4), 600–612. Two things differ. It is taken of red,
// green and blue, since colour maps have colours of one luminance. And their term of luminance, a ratio, hardly sees
// that light colours change; means are compared by their difference here.

constexpr int tile_size = 16, tile_step = 8;
/// The structure of what is fainter than about 8 of 255 counts for little: (0.03 · 255)², as the authors have it.
constexpr double faint_structure = 58.5;
/// Of 255: the difference of a tile's mean colour that halves its similarity.
constexpr double colour_scale = 25;

/// One of red, green and blue, blurred by 1 4 6 4 1 along rows and columns: an edge that is smoothed otherwise, or lies
/// half a pixel off, stays nearly what it was.
class Channel {
 public:
  Channel(const Image& image, std::size_t which) : width_(image.width), height_(image.height) {
    values_.resize(image.rgb.size() / 3);
    for (std::size_t i = 0; i < values_.size(); ++i) values_[i] = image.rgb[3 * i + which];
    blur(width_, height_, 1, width_);
    blur(height_, width_, width_, 1);
  }

  double at(int x, int y) const { return values_[index(y * static_cast<std::ptrdiff_t>(width_) + x)]; }

 private:
  static std::size_t index(std::ptrdiff_t i) { return static_cast<std::size_t>(i); }

  /// Blurs `lines` lines of `length` values each.
  void blur(int length, int lines, std::ptrdiff_t along, std::ptrdiff_t across) {
    constexpr std::array<float, 5> weights{1 / 16.F, 4 / 16.F, 6 / 16.F, 4 / 16.F, 1 / 16.F};
    std::vector<float> line(index(length));
    for (int l = 0; l < lines; ++l) {
      for (int i = 0; i < length; ++i) line[index(i)] = values_[index(l * across + i * along)];
      for (int i = 0; i < length; ++i) {
        float sum = 0;
        for (int k = -2; k <= 2; ++k) sum += weights[index(k + 2)] * line[index(std::clamp(i + k, 0, length - 1))];
        values_[index(l * across + i * along)] = sum;
      }
    }
  }

  int width_, height_;
  std::vector<float> values_;
};

double similarity(const Channel& a, const Channel& b, const PictureTile& tile) {
  double sum_a = 0, sum_b = 0, sum_aa = 0, sum_bb = 0, sum_ab = 0;
  for (int y = tile.top; y < tile.top + tile.height; ++y)
    for (int x = tile.left; x < tile.left + tile.width; ++x) {
      const double p = a.at(x, y), q = b.at(x, y);
      sum_a += p;
      sum_b += q;
      sum_aa += p * p;
      sum_bb += q * q;
      sum_ab += p * q;
    }
  const double count = tile.width * tile.height, mean_a = sum_a / count, mean_b = sum_b / count;
  const double variances = (sum_aa / count - mean_a * mean_a) + (sum_bb / count - mean_b * mean_b);
  const double covariance = sum_ab / count - mean_a * mean_b;
  const double structure = (2 * covariance + faint_structure) / (variances + faint_structure);
  const double off = (mean_a - mean_b) / colour_scale;
  return std::max(0.0, structure) / (1 + off * off);
}

/// Where tiles begin along a side; the last one ends with it.
std::vector<int> tile_starts(int side) {
  std::vector<int> all;
  for (int at = 0; at + tile_size < side; at += tile_step) all.push_back(at);
  all.push_back(std::max(0, side - tile_size));
  return all;
}

/// Calls `see` with every tile and its similarity, that of its worst channel.
template <class See>
void for_each_tile(const Image& expected, const Image& actual, See see) {
  if (expected.width != actual.width || expected.height != actual.height)
    throw std::invalid_argument("pictures of two sizes are compared");
  const std::array<Channel, 3> a{Channel(expected, 0), Channel(expected, 1), Channel(expected, 2)};
  const std::array<Channel, 3> b{Channel(actual, 0), Channel(actual, 1), Channel(actual, 2)};
  for (const int top : tile_starts(actual.height))
    for (const int left : tile_starts(actual.width)) {
      const PictureTile tile{left, top, std::min(tile_size, actual.width), std::min(tile_size, actual.height)};
      double worst = 1;
      for (std::size_t c = 0; c < 3; ++c) worst = std::min(worst, similarity(a[c], b[c], tile));
      see(tile, worst);
    }
}

PictureTile tile_around(const PictureTile& a, const PictureTile& b) {
  if (a.width == 0) return b;
  const int left = std::min(a.left, b.left), top = std::min(a.top, b.top);
  return {left, top, std::max(a.left + a.width, b.left + b.width) - left,
          std::max(a.top + a.height, b.top + b.height) - top};
}

constexpr Rgb fault_colour = rgb(0xd00000);

/// The pixel in pale grey, the redder the less its tile is alike.
Rgb heat(Rgb pixel, double similarity, double threshold) {
  const int grey = (pixel.red + pixel.green + pixel.blue) / 3;
  const auto pale = static_cast<std::uint8_t>(170 + grey / 3);
  const Rgb paper{pale, pale, pale};
  return similarity >= threshold ? paper : mix(paper, fault_colour, 0.25 + 0.6 * (1 - similarity / threshold));
}

void frame_region(Image& image, int shift, const PictureTile& tile) {
  const auto inside = [](int at, int side) { return std::clamp(at, 0, side - 1); };
  const int last_x = shift + tile.left + tile.width, last_y = tile.top + tile.height;
  for (int line = 1; line <= 2; ++line) {
    const int left = std::max(shift, shift + tile.left - line), right = inside(last_x - 1 + line, image.width);
    const int top = inside(tile.top - line, image.height), bottom = inside(last_y - 1 + line, image.height);
    for (int x = left; x <= right; ++x)
      for (const int y : {top, bottom}) image.set(x, y, fault_colour);
    for (int y = top; y <= bottom; ++y)
      for (const int x : {left, right}) image.set(x, y, fault_colour);
  }
}

}  // namespace

PictureDifference compare_pictures(const Image& expected, const Image& actual, double threshold) {
  PictureDifference found;
  for_each_tile(expected, actual, [&](const PictureTile& tile, double similarity) {
    if (found.tiles++ == 0 || similarity < found.similarity) {
      found.similarity = similarity;
      found.worst = tile;
    }
    if (similarity >= threshold) return;
    ++found.differing;
    found.region = tile_around(found.region, tile);
  });
  return found;
}

Image difference_picture(const Image& expected, const Image& actual, double threshold) {
  constexpr int gap = 8;
  const int width = actual.width, height = actual.height;
  std::vector<double> similarities(actual.rgb.size() / 3, 1);
  PictureTile region;
  for_each_tile(expected, actual, [&](const PictureTile& tile, double similarity) {
    if (similarity >= threshold) return;
    region = tile_around(region, tile);
    for (int y = tile.top; y < tile.top + tile.height; ++y)
      for (int x = tile.left; x < tile.left + tile.width; ++x) {
        double& worst = similarities[actual.pixel(x, y)];
        worst = std::min(worst, similarity);
      }
  });
  Image picture(3 * width + 2 * gap, height);
  const int second = width + gap, third = 2 * second;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double similarity = similarities[actual.pixel(x, y)];
      picture.set(x, y, expected.at(x, y));
      picture.set(second + x, y, actual.at(x, y));
      picture.set(third + x, y, heat(actual.at(x, y), similarity, threshold));
    }
  if (region.width > 0) frame_region(picture, third, region);
  return picture;
}

}  // namespace talus
