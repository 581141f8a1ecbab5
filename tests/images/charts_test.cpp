#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "images/baseline.hpp"
#include "images/compare.hpp"
#include "render/charts/charts.hpp"
#include "render/paint/colour_map.hpp"

namespace talus {
namespace {

constexpr int chart_width = 800, chart_height = 500;

HistoryRow history_row(double time) {
  const double s = std::max(0.0, time - 40);
  const double u = s < 22 ? 0.36 * s * s : 174 + 12 * (s - 22) + 25 * std::sin((s - 22) / 6);
  HistoryRow row;
  row.time = time;
  row.monitors = {{Vec3(-0.08 * u, u, -0.42 * u), Vec3(0, 0, 0)}};
  return row;
}

TEST(ChartImage, HistoryWithEvents) {
  std::vector<HistoryRow> history;
  for (int i = 0; i <= 1000; ++i) history.push_back(history_row(0.1 * i));
  HistoryPlot plot = monitor_plot("P1", 0, history, Quantity::Field::displacement);
  plot.marks = {{40, "strength lost"},   {44.2, "J2 opened"},       {45, "sliding starts", true},  {46.1, "J5 opened"},
                {62, "B3 leaves", true}, {63.7, "B3 lost contact"}, {99, "at rest at the far end"}};
  const Image image = draw_chart(plot, chart_width, chart_height);
  for (int s = 0; s < 3; ++s) EXPECT_GT(count_of(image, curve_palette(Theme::light)[static_cast<std::size_t>(s)]), 100);
  EXPECT_EQ(image.at(1, 1), rgb(0xffffff));
  expect_baseline(image);
}

TEST(ChartImage, DarkWithGapsAndASmallRange) {
  HistoryPlot plot;
  plot.theme = Theme::dark;
  plot.title = "Unbalanced force";
  plot.y_title = "Force";
  plot.y_unit = "kN";
  Series series{.name = "residual", .x = {}, .y = {}};
  for (int i = 0; i <= 400; ++i) {
    series.x.push_back(0.01 * i);
    series.y.push_back(i > 150 && i < 200 ? std::nan("") : 12000 + 300 * std::sin(0.1 * i) * std::exp(-0.01 * i));
  }
  plot.series = {series, {"target", {0, 4}, {12000, 12000}}};
  const Image image = draw_chart(plot, chart_width, chart_height);
  EXPECT_GT(count_of(image, curve_palette(Theme::dark)[0]), 100);
  expect_baseline(image);
}

}  // namespace
}  // namespace talus
