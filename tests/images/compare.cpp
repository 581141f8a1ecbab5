#include "images/compare.hpp"

#include <cmath>

#include "render/paint/picture_difference.hpp"

namespace talus {
namespace {

template <class Predicate>
int count_pixels(const Image& image, Predicate matches) {
  int count = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) count += matches(image.at(x, y));
  return count;
}

}  // namespace

double difference(const Image& a, const Image& b) {
  const PictureDifference found = compare_pictures(a, b);
  return static_cast<double>(found.differing) / found.tiles;
}

bool shows_lit(const Image& image, Rgb colour, double share) {
  const auto matches = [&](Rgb seen) {
    const double brightness = (seen.red + seen.green + seen.blue) / double(colour.red + colour.green + colour.blue);
    const auto near = [&](int channel, int wanted) { return std::abs(channel - brightness * wanted) < 9; };
    return brightness > 0.35 && near(seen.red, colour.red) && near(seen.green, colour.green) &&
           near(seen.blue, colour.blue);
  };
  return count_pixels(image, matches) > share * image.width * image.height;
}

int count_of(const Image& image, Rgb colour) {
  return count_pixels(image, [&](Rgb seen) {
    return std::abs(seen.red - colour.red) <= 2 && std::abs(seen.green - colour.green) <= 2 &&
           std::abs(seen.blue - colour.blue) <= 2;
  });
}

}  // namespace talus
