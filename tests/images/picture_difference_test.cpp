#include "render/paint/picture_difference.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "images/test_scenes.hpp"
#include "render/paint/colour_map.hpp"
#include "render/scene/offscreen.hpp"
#include "render/scene/scene.hpp"

// The comparison of pictures, by faults that are put into one on purpose and by what is no fault.
namespace talus {
namespace {

/// A slope in mid-slide, coloured by displacement, with its legend.
class PictureFaults : public testing::Test {
 protected:
  PictureFaults() : slope_(jointed_slope()), scene_(slope_, settings()) {
    const auto frame = slid(slope_, 14, 45);
    scene_.include_in_view(*frame);
    scene_.set_frame(frame);
    scene_.look(azimuth, 25);
    right_ = draw();
  }

  static SceneSettings settings() {
    SceneSettings settings;
    settings.title = "Jointed slope";
    settings.field = field_named("displacement");
    return settings;
  }
  Image draw() { return draw_image(scene_, 800, 500); }
  double similarity_of(const Image& other) const { return compare_pictures(right_, other).similarity; }

  static constexpr double azimuth = 290;
  BlockSystem slope_;
  Scene scene_;
  Image right_;
};

TEST_F(PictureFaults, ABlockThatIsGoneIsCaught) {
  scene_.set_hidden({6});
  const PictureDifference found = compare_pictures(right_, draw());
  EXPECT_LT(found.similarity, 0.1);
  EXPECT_LT(found.region.width * found.region.height, 800 * 500 / 20) << "the region is the block's";
}

/// The colour of the map at 1 − t where the pixel has that at t, in the same light; greys stay.
Rgb from_the_other_end(Rgb pixel) {
  const auto [low, high] = std::minmax({pixel.red, pixel.green, pixel.blue});
  if (high - low < 40) return pixel;
  const Vec3 seen(pixel.red, pixel.green, pixel.blue);
  double nearest = 1e9, light = 0;
  int found = 0;
  for (int i = 0; i < 256; ++i) {
    const Rgb entry = batlow().table()[static_cast<std::size_t>(i)];
    const Vec3 colour(entry.red, entry.green, entry.blue);
    const double lit = seen.dot(colour) / colour.squaredNorm(), off = (seen - lit * colour).norm();
    if (off >= nearest) continue;
    nearest = off;
    light = std::min(lit, 1.0);
    found = i;
  }
  return mix(Rgb{}, batlow().table()[static_cast<std::size_t>(255 - found)], light);
}

TEST_F(PictureFaults, AColourMapTheOtherWayRoundIsCaught) {
  Image flipped = right_;
  for (int y = 0; y < right_.height; ++y)
    for (int x = 0; x < right_.width; ++x) flipped.set(x, y, from_the_other_end(right_.at(x, y)));
  EXPECT_LT(similarity_of(flipped), alike_enough);
}

TEST_F(PictureFaults, ALegendThatIsGoneIsCaught) {
  SceneSettings without = settings();
  without.legend = false;
  scene_.set_settings(without);
  EXPECT_LT(similarity_of(draw()), alike_enough);
}

TEST_F(PictureFaults, ALegendThreePixelsOffIsCaught) {
  constexpr int left = 5, right = 150, top = 35, bottom = 260;  // the legend and some background
  Image shifted = right_;
  for (int y = top; y < bottom; ++y)
    for (int x = left + 3; x < right; ++x) shifted.set(x, y, right_.at(x - 3, y));
  EXPECT_LT(similarity_of(shifted), alike_enough);
}

TEST_F(PictureFaults, ACameraHalfADegreeOffIsCaught) {
  scene_.look(azimuth + 0.5, 25);
  EXPECT_LT(similarity_of(draw()), alike_enough);
}

/// As between drivers that round otherwise: more than any smoothing of edges changes.
TEST_F(PictureFaults, HalfAPixelIsForgivenAndAWholeOneIsNot) {
  Image half = right_, whole = right_;
  for (int y = 0; y < right_.height; ++y)
    for (int x = 1; x < right_.width; ++x) {
      half.set(x, y, mix(right_.at(x, y), right_.at(x - 1, y), 0.5));
      whole.set(x, y, right_.at(x - 1, y));
    }
  EXPECT_GT(similarity_of(half), alike_enough);
  EXPECT_LT(similarity_of(whole), alike_enough);
}

TEST_F(PictureFaults, EdgesSmoothedOtherwiseAndNoiseAreForgiven) {
  std::mt19937 chance(1);
  std::uniform_real_distribution<double> share(0, 0.5);
  std::uniform_int_distribution<int> noise(-2, 2), side(0, 3);
  Image smoothed = right_;
  for (int y = 1; y + 1 < right_.height; ++y)
    for (int x = 1; x + 1 < right_.width; ++x) {
      const int to = side(chance);
      const Rgb neighbour = right_.at(x + (to == 0) - (to == 1), y + (to == 2) - (to == 3));
      smoothed.set(x, y, mix(right_.at(x, y), neighbour, share(chance)));
    }
  for (auto& value : smoothed.rgb) value = static_cast<std::uint8_t>(std::clamp(value + noise(chance), 0, 255));
  EXPECT_GT(similarity_of(smoothed), 0.9);
}

}  // namespace
}  // namespace talus
