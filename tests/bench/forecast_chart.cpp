#include "bench/forecast_chart.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "render/charts/log_axis.hpp"
#include "render/charts/painted_image.hpp"
#include "render/paint/theme.hpp"

namespace talus {

namespace {

constexpr double held_to = 1.3;
// In text heights.
constexpr double axis_line = 0.06, grid_line = 0.05, bar_line = 0.12, disc = 0.36;
constexpr double left_room = 5.5, right_room = 1.5, bottom_room = 4.2, top_room = 4.6;

class ForecastChart {
 public:
  ForecastChart(const std::vector<ForecastPoint>& points, double width, double height)
      : points_(points),
        em_(height / 40),
        area_{left_room * em_, bottom_room * em_, width - right_room * em_, height - top_room * em_} {
    std::vector<double> seconds;
    for (const ForecastPoint& point : points)
      for (const double one : {point.fewest, point.most, point.measured})
        if (one > 0) seconds.push_back(one);
    axis_ = make_log_axis(seconds);
  }

  void paint(Painter& painter, const std::string& title) const {
    paint_band(painter);
    paint_grid(painter);
    for (const ForecastPoint& point : points_) paint_point(painter, point);
    paint_words(painter, title);
  }

 private:
  PixelPoint at(double measured, double foreseen) const {
    return {area_.left + area_.width() * axis_.share(measured),
            area_.bottom + area_.height() * std::clamp(axis_.share(foreseen), 0.0, 1.0)};
  }

  void paint_band(Painter& painter) const {
    const std::array<PixelPoint, 6> band = {
        at(axis_.low, axis_.low),   at(axis_.low * held_to, axis_.low),   at(axis_.high, axis_.high / held_to),
        at(axis_.high, axis_.high), at(axis_.high / held_to, axis_.high), at(axis_.low, axis_.low * held_to)};
    painter.fill(band, curve_palette(Theme::light)[0], 0.15);
    painter.line(at(axis_.low, axis_.low), at(axis_.high, axis_.high), axis_line * em_, colours_.muted);
  }

  void paint_grid(Painter& painter) const {
    for (const double tick : axis_.ticks) {
      painter.line(at(tick, axis_.low), at(tick, axis_.high), grid_line * em_, colours_.frame);
      painter.line(at(axis_.low, tick), at(axis_.high, tick), grid_line * em_, colours_.frame);
      const PixelPoint x = at(tick, axis_.low), y = at(axis_.low, tick);
      painter.text({x.x, x.y - 0.5 * em_}, tick_text(tick), words(AlignX::centre, AlignY::top));
      painter.text({y.x - 0.6 * em_, y.y}, tick_text(tick), words(AlignX::right, AlignY::centre));
    }
    painter.line(at(axis_.low, axis_.low), at(axis_.high, axis_.low), axis_line * em_, colours_.line);
    painter.line(at(axis_.low, axis_.low), at(axis_.low, axis_.high), axis_line * em_, colours_.line);
  }

  Rgb colour_of(const ForecastPoint& point) const {
    return point.seen_whole ? colours_.muted : curve_palette(Theme::light)[0];
  }

  void paint_point(Painter& painter, const ForecastPoint& point) const {
    painter.line(at(point.measured, std::max(point.fewest, axis_.low)), at(point.measured, point.most), bar_line * em_,
                 colour_of(point), 0.5);
    painter.disc(at(point.measured, point.seconds), disc * em_, colour_of(point));
  }

  void paint_words(Painter& painter, const std::string& title) const {
    TextStyle heading = words(AlignX::left, AlignY::top);
    heading.height = 1.3 * em_;
    heading.weight = FontWeight::semibold;
    painter.text({area_.left, area_.top + 4 * em_}, title, heading);
    painter.text({area_.left, area_.top + 1.9 * em_}, "Bars: the range that is said. Band: within 30 %.",
                 words(AlignX::left, AlignY::top));
    painter.text({(area_.left + area_.right) / 2, 1 * em_}, "Measured, processor time (s)",
                 words(AlignX::centre, AlignY::bottom));
    TextStyle upwards = words(AlignX::centre, AlignY::top);
    upwards.upwards = true;
    painter.text({1 * em_, (area_.bottom + area_.top) / 2}, "Foreseen, processor time (s)", upwards);
  }

  TextStyle words(AlignX x, AlignY y) const { return {.height = em_, .colour = colours_.text, .x = x, .y = y}; }

  const std::vector<ForecastPoint>& points_;
  const ThemeColours& colours_ = colours(Theme::light);
  double em_;
  PixelRect area_;
  LogAxis axis_;
};

}  // namespace

Image draw_forecast_chart(const std::string& title, const std::vector<ForecastPoint>& points, int width, int height) {
  if (points.empty()) throw std::invalid_argument("a chart of forecasts needs a run");
  return painted_image(width, height, colours(Theme::light).surface, [&](Painter& painter, double w, double h) {
    ForecastChart(points, w, h).paint(painter, title);
  });
}

}  // namespace talus
