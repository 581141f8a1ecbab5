#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "render/paint/colour_map.hpp"
#include "render/paint/theme.hpp"
#include "render/scene/field_range.hpp"

namespace talus {
namespace {

double luminance(Rgb c) {
  const auto linear = [](std::uint8_t channel) {
    const double v = channel / 255.0;
    return v <= 0.03928 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(c.red) + 0.7152 * linear(c.green) + 0.0722 * linear(c.blue);
}

double contrast(Rgb a, Rgb b) {
  const double x = luminance(a), y = luminance(b);
  return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}

// Rows of the published tables (Scientific colour maps 8.0), times 255.
TEST(ColourMap, HoldsThePublishedTables) {
  EXPECT_EQ(batlow().at(0), (Rgb{1, 25, 89}));
  EXPECT_EQ(batlow().at(1), (Rgb{250, 204, 250}));
  EXPECT_EQ(vik().at(0), (Rgb{0, 18, 97}));
  EXPECT_EQ(vik().at(1), (Rgb{89, 0, 8}));
}

TEST(ColourMap, ClampsAndInterpolates) {
  EXPECT_EQ(batlow().at(-3), batlow().at(0));
  EXPECT_EQ(batlow().at(7), batlow().at(1));
  EXPECT_EQ(batlow().at(100 / 255.0), batlow().table()[100]);
  EXPECT_EQ(batlow().at(100.5 / 255), mix(batlow().table()[100], batlow().table()[101], 0.5));
}

TEST(ColourMap, BatlowGrowsLighterAndVikIsLightestInTheMiddle) {
  for (int i = 8; i < 256; i += 8) EXPECT_GT(luminance(batlow().table()[i]), luminance(batlow().table()[i - 8])) << i;
  EXPECT_GT(luminance(vik().at(0.5)), 0.7);
  EXPECT_LT(luminance(vik().at(0)), 0.05);
  EXPECT_LT(luminance(vik().at(1)), 0.05);
}

TEST(Theme, WritingCanBeReadOnEveryGround) {
  for (const Theme theme : {Theme::light, Theme::dark}) {
    const ThemeColours& c = colours(theme);
    for (const Rgb ground : {c.view_top, c.view_bottom, c.surface}) {
      EXPECT_GE(contrast(c.text, ground), 7);
      EXPECT_GE(contrast(c.muted, ground), 4);
    }
    for (const Rgb curve : curve_palette(theme)) EXPECT_GE(contrast(curve, c.surface), 3);
  }
}

TEST(ValueRange, IgnoresWhatIsNotFinite) {
  ValueRange range;
  EXPECT_TRUE(range.empty());
  const std::vector<double> values{3, std::nan(""), -1, INFINITY};
  range.include(values);
  EXPECT_EQ(range, (ValueRange{-1, 3}));
}

TEST(LegendRange, BeginsAtZeroOrIsSymmetric) {
  EXPECT_EQ(legend_range(field_named("displacement"), {0.3, 16.3}), (ValueRange{0, 20}));
  EXPECT_EQ(legend_range(field_named("stress.zz"), {-1.4e6, 2e5}), (ValueRange{-1.5e6, 1.5e6}));
  EXPECT_EQ(legend_range(field_named("velocity"), {0, 0}), (ValueRange{0, 1}));
  EXPECT_EQ(legend_range(field_named("velocity.x"), ValueRange{}), (ValueRange{-1, 1}));
}

}  // namespace
}  // namespace talus
