#include "images/compare.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

namespace talus {
namespace {

constexpr int cell = 4;

std::array<double, 3> mean_colour(const Image& image, int left, int top) {
  std::array<double, 3> sum{};
  int count = 0;
  for (int y = top; y < std::min(top + cell, image.height); ++y)
    for (int x = left; x < std::min(left + cell, image.width); ++x, ++count) {
      const Rgb c = image.at(x, y);
      sum[0] += c.red;
      sum[1] += c.green;
      sum[2] += c.blue;
    }
  for (double& channel : sum) channel /= count;
  return sum;
}

template <class Predicate>
int count_pixels(const Image& image, Predicate matches) {
  int count = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) count += matches(image.at(x, y));
  return count;
}

}  // namespace

double difference(const Image& a, const Image& b) {
  if (a.width != b.width || a.height != b.height) return 1;
  int cells = 0, differing = 0;
  for (int y = 0; y < a.height; y += cell)
    for (int x = 0; x < a.width; x += cell, ++cells) {
      const auto p = mean_colour(a, x, y), q = mean_colour(b, x, y);
      double largest = 0;
      for (int i = 0; i < 3; ++i) largest = std::max(largest, std::abs(p[i] - q[i]));
      differing += largest > 10;
    }
  return static_cast<double>(differing) / cells;
}

void expect_baseline(const Image& image) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const std::string name = std::string(test->test_suite_name()) + "." + test->name() + ".png";
  const auto baseline = std::filesystem::path(TALUS_SOURCE_DIR) / "tests/images/baselines" / name;
  const auto drawn = std::filesystem::absolute(name);
  if (!std::filesystem::exists(baseline)) {
    write_png(image, drawn);
    FAIL() << "no baseline yet: look at " << drawn << " and, if it is right, copy it to " << baseline;
  }
  const double differs = difference(image, read_png(baseline));
  if (differs <= tolerated_difference) return;
  write_png(image, drawn);
  FAIL() << 100 * differs << " % of the picture differs: compare " << drawn << " with " << baseline;
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
