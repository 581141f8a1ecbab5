#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "base/error.hpp"
#include "base/units.hpp"
#include "render/charts/chart_layout.hpp"
#include "render/charts/charts.hpp"
#include "render/scene/camera_fit.hpp"
#include "render/scene/overlay.hpp"

namespace talus {
namespace {

bool apart(const MarkLabel& a, const MarkLabel& b) {
  return a.row != b.row || a.left + a.width <= b.left || b.left + b.width <= a.left;
}

TEST(MarkLabels, NeverMeetAndAreCrossedByNoLine) {
  std::vector<MarkLabel> labels;
  for (const double line : {100.0, 104.0, 108.0, 150.0, 151.0, 400.0, 600.0})
    labels.push_back({.line = line, .width = 90});
  const int rows = arrange(labels, 4, 1000);
  EXPECT_EQ(rows, 5);
  for (std::size_t i = 0; i < labels.size(); ++i)
    for (std::size_t k = 0; k < labels.size(); ++k) {
      if (i == k) continue;
      EXPECT_TRUE(apart(labels[i], labels[k])) << i << ' ' << k;
      const bool spans = labels[i].left < labels[k].line && labels[k].line < labels[i].left + labels[i].width;
      EXPECT_FALSE(spans && labels[k].row >= labels[i].row) << "line " << k << " crosses label " << i;
    }
}

TEST(MarkLabels, StandOnTheLeftWhereTheRightHasNoRoom) {
  std::vector<MarkLabel> labels{{.line = 880, .width = 50}, {.line = 950, .width = 100}};
  EXPECT_EQ(arrange(labels, 4, 1000), 2);
  EXPECT_DOUBLE_EQ(labels[1].left, 846);
  EXPECT_GT(labels[1].row, labels[0].row);
}

TEST(Spread, KeepsOrderAndDistance) {
  const std::vector<double> placed = spread({50, 51, 10, 49}, 12, 0, 100);
  EXPECT_DOUBLE_EQ(placed[2], 10);
  EXPECT_DOUBLE_EQ(placed[3], 38);
  EXPECT_DOUBLE_EQ(placed[0], 50);
  EXPECT_DOUBLE_EQ(placed[1], 62);
  EXPECT_EQ(spread({0, 1}, 12, 0, 100), (std::vector<double>{0, 12}));
}

TEST(Simplified, KeepsCornersAndDropsWhatIsStraight) {
  std::vector<PixelPoint> points;
  for (int i = 0; i <= 100; ++i) points.push_back({double(i), i <= 50 ? 0.0 : i - 50.0});
  const auto kept = simplified(points, 0.1);
  ASSERT_EQ(kept.size(), 3u);
  EXPECT_DOUBLE_EQ(kept[1].x, 50);
}

TEST(CameraFit, TouchesTheFreeAreaAndStaysInside) {
  std::vector<Vec3> points;
  for (int i = 0; i < 8; ++i) points.push_back({i & 1 ? 130.0 : 100.0, i & 2 ? 20.0 : -4.0, i & 4 ? 11.0 : 0.0});
  for (const bool parallel : {false, true}) {
    CameraPose look;
    look.focal_point = {0, 0, 0};
    look.position = direction_to_viewer(225, 30);
    look.view_up = Vec3::UnitZ();
    look.parallel = parallel;
    const double width = 900, height = 500, picture = 720;
    const CameraPose pose = fitted(look, points, width, height, picture);
    const Vec3 forward = (pose.focal_point - pose.position).normalized();
    const Vec3 right = forward.cross(pose.view_up).normalized(), up = right.cross(forward);
    double left_most = 0, right_most = 0, lowest = 0, highest = 0;
    for (const Vec3& point : points) {
      const Vec3 from = point - pose.position;
      const double plane = parallel ? pose.parallel_scale : from.dot(forward) * std::tan(radians(pose.view_angle) / 2);
      const double x = from.dot(right) / plane * picture / 2, y = from.dot(up) / plane * picture / 2;
      left_most = std::min(left_most, x);
      right_most = std::max(right_most, x);
      lowest = std::min(lowest, y);
      highest = std::max(highest, y);
    }
    // The tighter direction is filled exactly; in the other one near points weigh more than far ones.
    EXPECT_NEAR(left_most, -right_most, 0.02 * width);
    EXPECT_NEAR(lowest, -highest, 1e-9);
    EXPECT_LE(right_most, width / 2 + 1e-9);
    EXPECT_LE(highest, height / 2 + 1e-9);
    EXPECT_NEAR(std::max(right_most / (width / 2), highest / (height / 2)), 1, 1e-9);
  }
}

TEST(ViewExtent, KeepsTheOutermostPoints) {
  ViewExtent extent;
  EXPECT_TRUE(extent.points().empty());
  for (int i = 0; i < 1000; ++i) extent.include(Vec3(std::sin(i), std::cos(3 * i), std::sin(5 * i)));
  extent.include({0, 40, 0});
  double farthest = 0;
  for (const Vec3& point : extent.points()) farthest = std::max(farthest, point.y());
  EXPECT_DOUBLE_EQ(farthest, 40);
}

TEST(Views, LookFromWhereTheirNameSays) {
  EXPECT_EQ(view_named("left"), View::left);
  const auto [azimuth, elevation] = view_angles(View::left);
  EXPECT_TRUE(direction_to_viewer(azimuth, elevation).isApprox(-Vec3::UnitX(), 1e-12));
  EXPECT_THROW(view_named("below"), InputError);
}

TEST(Overlay, LeavesTheRockAFreeAreaBesideTheLegend) {
  Overlay overlay{.text_height = 15, .title = "Slope", .time = "t = 1.00 s", .remarks = {}, .legend = {}};
  const PixelRect without = free_area(overlay, 1280, 720);
  overlay.legend = Legend{.title = "Smallest principal stress", .unit = "MPa", .map = &vik(), .low = -20, .high = 20};
  const PixelRect with = free_area(overlay, 1280, 720);
  EXPECT_GT(with.left, without.left);
  EXPECT_LT(with.left, 0.25 * 1280);
  EXPECT_GT(with.width(), 0.7 * 1280);
  EXPECT_GT(with.height(), 0.75 * 720);
}

TEST(Wrapped, BreaksBetweenWordsOnly) {
  const double one = text_width("Smallest principal", 16, FontWeight::semibold);
  const auto lines = wrapped("Smallest principal stress", one + 1, 16, FontWeight::semibold);
  EXPECT_EQ(lines, (std::vector<std::string>{"Smallest principal", "stress"}));
  EXPECT_EQ(wrapped("Displacement", 5, 16, FontWeight::regular), (std::vector<std::string>{"Displacement"}));
  EXPECT_EQ(wrapped("off by 8.4 % at most", 5, 16, FontWeight::regular),
            (std::vector<std::string>{"off", "by", "8.4 %", "at", "most"}));
}

TEST(Font, HasGreekThinSpacesAndPowers) {
  for (const char* text : {"\u03c6", "\u2212", "\u207b\u2075", "\u00b5m"}) EXPECT_GT(text_width(text, 40), 5) << text;
  EXPECT_LT(text_width("1\u2009"
                       "0",
                       40),
            text_width("1 0", 40));
}

TEST(MonitorPlot, HasThreeComponentsInAFittingUnit) {
  std::vector<HistoryRow> history(2);
  history[1].time = 2;
  for (HistoryRow& row : history)
    row.monitors = {{Vec3(1, 2, 3), Vec3::Zero()}, {row.time * Vec3(1e-3, 0, -2e-3), Vec3::Zero()}};
  const HistoryPlot plot = monitor_plot("P2", 1, history, Quantity::Field::displacement);
  ASSERT_EQ(plot.series.size(), 3u);
  EXPECT_EQ(plot.y_unit, "mm");
  EXPECT_NEAR(plot.series[2].y[1], -4, 1e-12);
  EXPECT_EQ(plot.series[0].x, (std::vector<double>{0, 2}));
}

TEST(MonitorPlot, HasSixComponentsOfStress) {
  std::vector<HistoryRow> history(2);
  history[1].time = 2;
  for (HistoryRow& row : history) {
    row.monitors = {{Vec3::Zero(), Vec3::Zero()}};
    row.monitors[0].stress.emplace();
    *row.monitors[0].stress << 0, 0, -3e6 * row.time, 0, 0, 1e6;
  }
  const HistoryPlot plot = monitor_plot("P1", 0, history, Quantity::Field::stress);
  ASSERT_EQ(plot.series.size(), 6u);
  EXPECT_EQ(plot.y_unit, "MPa");
  EXPECT_EQ(plot.series[2].name, "zz");
  EXPECT_NEAR(plot.series[2].y[1], -6, 1e-12);
  EXPECT_NEAR(plot.series[5].y[0], 1, 1e-12);
}

TEST(Chart, RefusesWhatItCannotDraw) {
  EXPECT_THROW(draw_chart(HistoryPlot{}), std::invalid_argument);
  HistoryPlot plot;
  plot.series = {{"a", {0, 1}, {0}}};
  EXPECT_THROW(draw_chart(plot), std::invalid_argument);
  plot.series = {{"a", {0, 1}, {0, 1}}};
  EXPECT_THROW(draw_chart(plot, 100, 100), InputError);
}

}  // namespace
}  // namespace talus
