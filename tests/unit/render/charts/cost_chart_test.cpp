#include "render/charts/cost_chart.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "base/error.hpp"

namespace talus {
namespace {

CostPlot two_runs() {
  CostPlot plot;
  plot.title = "Slope";
  plot.error_title = "Error";
  plot.groups = {"rigid"};
  plot.points = {{.number = 0, .label = "rigid", .seconds = 1, .error = 0.01, .on_front = true, .recommended = true},
                 {.number = 1, .label = "rigid · 4Δ", .seconds = 0.3, .error = 0, .uncertainty = 0.002}};
  return plot;
}

int pixels_of(const Image& image, Rgb colour) {
  int count = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) count += image.at(x, y) == colour;
  return count;
}

TEST(CostChart, ShowsRunsInTheColourOfTheirGroupAndRingsTheRecommendedOne) {
  CostPlot plot = two_runs();
  const Image image = draw_cost_chart(plot, 900, 600);
  EXPECT_EQ(image.width, 900);
  EXPECT_GT(pixels_of(image, curve_palette(Theme::light)[0]), 200);
  EXPECT_GT(pixels_of(image, colours(Theme::light).pick), 20);
  plot.points[0].recommended = false;
  EXPECT_EQ(pixels_of(draw_cost_chart(plot, 900, 600), colours(Theme::light).pick), 0);
}

TEST(CostChart, DrawsAllErrorsThatAreRoundingAtItsFoot) {
  CostPlot plot = two_runs();
  plot.points[1].uncertainty = 0;
  plot.points.push_back({.number = 2, .label = "rigid", .seconds = 2, .error = 3e-13});  // the widest in the list
  const Image exact = draw_cost_chart(plot, 900, 600);
  plot.points[1].error = 0.5 * smallest_error;
  const Image rounded = draw_cost_chart(plot, 900, 600);
  const int chart = 450;  // px: the list of runs begins to the right of it
  for (int y = 0; y < exact.height; ++y)
    for (int x = 0; x < chart; ++x) ASSERT_TRUE(exact.at(x, y) == rounded.at(x, y)) << x << ' ' << y;
}

TEST(CostChart, RefusesWhatCannotBeDrawn) {
  EXPECT_THROW(draw_cost_chart({}), std::invalid_argument);
  CostPlot plot = two_runs();
  plot.points[0].seconds = 0;
  EXPECT_THROW(draw_cost_chart(plot), std::invalid_argument);
  plot = two_runs();
  plot.points[1].group = 1;
  EXPECT_THROW(draw_cost_chart(plot), std::invalid_argument);
  EXPECT_THROW(draw_cost_chart(two_runs(), 100, 100), InputError);
}

}  // namespace
}  // namespace talus
