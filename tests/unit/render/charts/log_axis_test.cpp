#include "render/charts/log_axis.hpp"

#include <gmock/gmock.h>

#include "render/charts/tag_layout.hpp"

#include <cmath>

namespace talus {
namespace {

TEST(LogAxis, HoldsItsValuesWithRoom) {
  const LogAxis axis = make_log_axis({0.01, 20});
  EXPECT_LT(axis.low, 0.01);
  EXPECT_GT(axis.high, 20);
  EXPECT_NEAR(axis.share(std::sqrt(axis.low * axis.high)), 0.5, 1e-12);
  EXPECT_THAT(axis.ticks,
              testing::ElementsAre(testing::DoubleNear(0.01, 1e-12), testing::DoubleNear(0.1, 1e-12), 1, 10));
}

TEST(LogAxis, OfOneValueSpansADecade) {
  const LogAxis axis = make_log_axis({3});
  EXPECT_GE(axis.high / axis.low, 10);
  EXPECT_GE(axis.ticks.size(), 2u);
}

TEST(LogAxis, WritesErrorsInPercent) {
  EXPECT_EQ(error_text(0.015), "1.5 %");
  EXPECT_EQ(error_text(2e-6), "2.0×10⁻⁴ %");
  EXPECT_EQ(error_text(0), "0 %");
  EXPECT_EQ(error_tick_text(0.001), "0.1 %");
  EXPECT_EQ(error_tick_text(1e-6), "10⁻⁴ %");
  EXPECT_EQ(tick_text(0.05), "0.05");
  EXPECT_EQ(tick_text(200), "200");
}

TEST(TagLayout, KeepsTagsApartAndInside) {
  const PixelRect rect{0, 0, 400, 300};
  const std::vector<PixelPoint> points(12, PixelPoint{20, 20});
  const auto tags = place_tags(points, 10, rect);
  EXPECT_EQ(tags.front().x, 20);
  for (std::size_t i = 0; i < tags.size(); ++i) {
    EXPECT_GE(tags[i].x, 10);
    EXPECT_GE(tags[i].y, 10);
    for (std::size_t k = 0; k < i; ++k) EXPECT_GE(std::hypot(tags[i].x - tags[k].x, tags[i].y - tags[k].y), 20 - 1e-9);
  }
}

}  // namespace
}  // namespace talus
