#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

#include "render/fields/field_range.hpp"
#include "render/paint/colour_map.hpp"
#include "render/paint/theme.hpp"

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

/// CIE 1976 L*, a*, b* under D65.
std::array<double, 3> lab(Rgb c) {
  const auto linear = [](std::uint8_t channel) {
    const double v = channel / 255.0;
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  };
  const auto root = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16 / 116.0; };
  const double r = linear(c.red), g = linear(c.green), b = linear(c.blue);
  const double x = root((0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.95047);
  const double y = root(0.2126 * r + 0.7152 * g + 0.0722 * b);
  const double z = root((0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.08883);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

double apart(Rgb a, Rgb b) {
  const auto p = lab(a), q = lab(b);
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

/// A difference of 2 is just seen; the orange that Tol's scheme has lies 29 from what is selected in the dark.
TEST(Theme, NoBlockLooksSelected) {
  for (const Theme theme : {Theme::light, Theme::dark})
    for (const Rgb block : block_palette())
      for (const double grey : {0.0, 0.25})
        EXPECT_GT(apart(mix(block, colours(Theme::light).rock, grey), colours(theme).pick), 40)
            << int(block.red) << ' ' << int(block.green) << ' ' << int(block.blue);
}

/// Curves, joint sets and what acts have one palette; the grounds are told apart from it by their contrast.
TEST(Theme, NoCurveLooksSelectedNorLikeAnother) {
  for (const Theme theme : {Theme::light, Theme::dark}) {
    const auto& curves = curve_palette(theme);
    for (std::size_t i = 0; i < curves.size(); ++i) {
      EXPECT_GE(apart(curves[i], colours(theme).pick), 44) << "curve " << i;
      for (std::size_t j = 0; j < i; ++j) EXPECT_GE(apart(curves[i], curves[j]), 30) << "curves " << i << ", " << j;
    }
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
