#include "render/scene/overlay.hpp"

#include <gtest/gtest.h>

namespace talus {
namespace {

/// Where words are painted.
class WordsPainter final : public Painter {
 public:
  struct Word {
    std::string text;
    PixelRect place;
  };
  std::vector<Word> words;

 private:
  void draw_rectangle(const PixelRect&, Rgb, double) override {}
  void draw_polygon(std::span<const PixelPoint>, Rgb, double) override {}
  void draw_line(std::span<const PixelPoint>, double, Rgb, double) override {}
  void draw_disc(PixelPoint, double, Rgb) override {}
  void draw_text(PixelPoint at, std::string_view text, const TextStyle& style) override {
    if (text.empty()) return;
    const double width = text_width(text, style.height, style.weight);
    const double left = at.x - width * (style.x == AlignX::left ? 0 : style.x == AlignX::centre ? 0.5 : 1);
    const double baseline = at.y - style.height * baseline_below(style.y);
    words.push_back({std::string(text), {left, baseline, left + width, baseline + 0.7 * style.height}});
  }
};

bool meet(const PixelRect& a, const PixelRect& b) {
  return a.left < b.right && b.left < a.right && a.bottom < b.top && b.bottom < a.top;
}

/// A foot with all that it may have.
Overlay full_foot(double width, double height, const std::string& remarks, bool with_key) {
  Overlay overlay;
  overlay.text_height = automatic_text_height(width, height);
  overlay.time = "t = 1234.56 s";
  overlay.remarks = remarks;
  if (with_key) overlay.key_title = "contacts", overlay.key = {{{}, "open"}, {{}, "stick"}, {{}, "slip"}};
  return overlay;
}

TEST(Overlay, WordsDoNotMeetInPicturesOfAnySize) {
  const std::string shortly = "slide", long_one =
                                           "slide, no material has a strength: give one to the rock on the page "
                                           "Materials";
  for (const auto& [width, height] : {std::pair{320.0, 240.0}, {480.0, 300.0}, {800.0, 500.0}, {1920.0, 1080.0}})
    for (const std::string& remarks : {std::string(), shortly, long_one})
      for (const bool with_key : {false, true}) {
        const Overlay overlay = full_foot(width, height, remarks, with_key);
        WordsPainter painter;
        paint(painter, overlay, {width, height, Vec3::UnitX(), Vec3::UnitZ(), -Vec3::UnitY(), 0.05});
        const double foot = free_area(overlay, width, height).bottom;
        for (auto a = painter.words.begin(); a != painter.words.end(); ++a) {
          EXPECT_GE(a->place.left, 0) << a->text;
          EXPECT_LE(a->place.right, width) << a->text;
          if (!remarks.empty() && remarks.find(a->text) != std::string::npos && !with_key) {
            EXPECT_LE(a->place.top, foot) << "the rock is not where remarks are: " << a->text;
          }
          for (auto b = std::next(a); b != painter.words.end(); ++b)
            EXPECT_FALSE(meet(a->place, b->place)) << width << ": " << a->text << " and " << b->text;
        }
      }
}

TEST(Overlay, OfALowPictureHasTheLegendAndNoAxesInIt) {
  for (const bool is_low : {true, false}) {
    const double width = 320, height = is_low ? 190 : 300;
    Overlay overlay = full_foot(width, height, {}, false);
    overlay.legend = Legend{.title = "Displacement", .unit = "m", .map = &batlow()};
    WordsPainter painter;
    paint(painter, overlay, {width, height, Vec3::UnitX(), Vec3::UnitZ(), -Vec3::UnitY(), 0.05});
    const auto is_axis = [](const auto& word) { return word.text == "E" || word.text == "Z"; };
    EXPECT_EQ(std::ranges::count_if(painter.words, is_axis), is_low ? 0 : 2);
  }
}

TEST(Overlay, LeavesRockItsPlaceBesideTheLegendOrBelowItInAnUprightPicture) {
  Overlay overlay;
  overlay.text_height = 11;
  overlay.time = "t = 1 s";
  const PixelRect plain = free_area(overlay, 408, 520);
  overlay.legend = Legend{.title = "Displacement", .unit = "m", .map = &batlow()};
  const PixelRect wide = free_area(overlay, 960, 600), upright = free_area(overlay, 408, 520);
  EXPECT_GT(wide.left, 100) << "beside";
  EXPECT_GT(wide.top, 580);
  EXPECT_EQ(upright.left, plain.left) << "below";
  EXPECT_LT(upright.top, plain.top - 100);
  EXPECT_GT(upright.height(), 200);
}

}  // namespace
}  // namespace talus
