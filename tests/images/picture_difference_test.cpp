#include "render/paint/picture_difference.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <random>

#include "images/baseline.hpp"
#include "images/test_scenes.hpp"
#include "render/paint/colour_map.hpp"
#include "render/scene/offscreen.hpp"
#include "render/scene/scene.hpp"

// The test of the tests of pictures: faults that are put into one on purpose are found, and what is no fault is not.
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

Image with_its_colour_map_flipped(const Image& right) {
  Image flipped = right;
  for (int y = 0; y < right.height; ++y)
    for (int x = 0; x < right.width; ++x) flipped.set(x, y, from_the_other_end(right.at(x, y)));
  return flipped;
}

TEST_F(PictureFaults, AColourMapTheOtherWayRoundIsCaught) {
  EXPECT_LT(similarity_of(with_its_colour_map_flipped(right_)), alike_enough);
}

TEST_F(PictureFaults, ALegendThatIsGoneIsCaught) {
  SceneSettings without = settings();
  without.legend = false;
  scene_.set_settings(without);
  EXPECT_LT(similarity_of(draw()), alike_enough);
}

Image with_its_legend_three_pixels_off(const Image& picture) {
  constexpr int left = 5, right = 150, top = 35, bottom = 260;  // the legend and some background
  Image shifted = picture;
  for (int y = top; y < bottom; ++y)
    for (int x = left + 3; x < right; ++x) shifted.set(x, y, picture.at(x - 3, y));
  return shifted;
}

TEST_F(PictureFaults, ALegendThreePixelsOffIsCaught) {
  EXPECT_LT(similarity_of(with_its_legend_three_pixels_off(right_)), alike_enough);
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

/// The same faults, as the suite meets them: a picture that is held to a baseline.
class Baseline : public PictureFaults {
 protected:
  Baseline() {
    std::filesystem::remove_all(folders.baselines.parent_path());
    BaselineFolders making = folders;
    making.update = true;
    EXPECT_EQ(held_to_baseline(right_, "slope", making), "");
  }
  ~Baseline() override { std::filesystem::remove_all(folders.baselines.parent_path()); }

  std::string held(const Image& drawn) const { return held_to_baseline(drawn, "slope", folders); }
  bool is_left(const char* what) const {
    return std::filesystem::exists(folders.differing / (std::string("slope.") + what + ".png"));
  }
  void expect_caught(const Image& faulty) const {
    const std::string said = held(faulty);
    EXPECT_NE(said.find(folders.differing.string()), std::string::npos) << "it says where to look: " << said;
    for (const char* what : {"expected", "actual", "difference"}) EXPECT_TRUE(is_left(what)) << what;
    EXPECT_EQ(read_png(folders.differing / "slope.actual.png").rgb, faulty.rgb);
  }

  BaselineFolders folders{std::filesystem::absolute("faults/baselines"), std::filesystem::absolute("faults/differing"),
                          false};
};

TEST_F(Baseline, CatchesABlockThatIsGone) {
  scene_.set_hidden({6});
  expect_caught(draw());
}

TEST_F(Baseline, CatchesAColourMapTheOtherWayRound) { expect_caught(with_its_colour_map_flipped(right_)); }

TEST_F(Baseline, CatchesALegendThreePixelsOff) { expect_caught(with_its_legend_three_pixels_off(right_)); }

TEST_F(Baseline, CatchesACameraHalfADegreeOff) {
  scene_.look(azimuth + 0.5, 25);
  expect_caught(draw());
}

TEST_F(Baseline, FlagsNothingWithoutAFaultAndTakesAwayWhatAnEarlierOneLeft) {
  scene_.set_hidden({6});
  expect_caught(draw());
  scene_.set_hidden({});
  EXPECT_EQ(held(draw()), "");
  for (const char* what : {"expected", "actual", "difference"}) EXPECT_FALSE(is_left(what)) << what;
}

TEST_F(Baseline, ThatIsMissingOrOfAnotherSizeFails) {
  EXPECT_NE(held_to_baseline(right_, "none", folders), "");
  EXPECT_NE(held(draw_image(scene_, 400, 250)), "");
}

TEST_F(Baseline, OfAFaultBecomesTheNewOneWhereThatIsAskedFor) {
  scene_.set_hidden({6});
  BaselineFolders making = folders;
  making.update = true;
  EXPECT_EQ(held_to_baseline(draw(), "slope", making), "");
  EXPECT_EQ(held(draw()), "");
  EXPECT_NE(held(right_), "");
}

}  // namespace
}  // namespace talus
