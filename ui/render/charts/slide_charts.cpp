#include "render/charts/slide_charts.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "render/charts/chart_layout.hpp"
#include "render/paint/colour_map.hpp"
#include "render/paint/numbers.hpp"
#include "render/paint/picture_words.hpp"
#include "render/paint/value_range.hpp"

namespace talus {

namespace {

/// What a map shows of the ground, m, with a margin.
struct Ground {
  double west = 0, south = 0, across = 0, up = 0;
};

Ground ground_of(const Slide& slide) {
  ValueRange x, y;
  for (const auto* rings : {&slide.deposit.outline, &slide.source})
    for (const PlanRing& ring : *rings)
      for (const auto& [east, north] : ring) {
        x.include(east);
        y.include(north);
      }
  const double margin = 0.04 * std::max(x.high - x.low, y.high - y.low);
  return {x.low - margin, y.low - margin, x.high - x.low + 2 * margin, y.high - y.low + 2 * margin};
}

// Of a map, in text heights.
constexpr double least_height_of_high = 26;    ///< below: the key stands beside the colours, not below them
constexpr double least_height_of_titled = 16;  ///< below: there is hardly room for a map
constexpr double left_of_map = 6.5, below_map = 4.2;
double right_of_map(bool low) { return low ? 19 : 14; }
double above_map(bool titled) { return titled ? 4 : 1; }
double text_height_for(double width, double height) { return std::max(11.0, std::min(height / 40, width / 60)); }

/// A map of a given size, laid out once and then painted. Lengths in text heights where nothing else is said. North is
/// up, or at the right where the ground is long from south to north and the map is then much larger.
class DepositMap {
 public:
  DepositMap(const Slide& slide, Theme theme, double width, double height)
      : slide_(slide), colours_(colours(theme)), em_(text_height_for(width, height)), ground_(ground_of(slide)) {
    scale_end_ = round_up(slide.deposit.max_depth);
    low_ = height < least_height_of_high * em_;
    titled_ = height >= least_height_of_titled * em_;
    place(width, height);
  }

  void paint(Painter& painter) const {
    if (titled_)
      painter.text({map_.left, map_.top + 1.2 * em_},
                   picture_word("Depth of the deposit at") + " " + format_number(slide_.time, 3) + " s",
                   {.height = 1.25 * em_, .colour = colours_.text, .weight = FontWeight::semibold});
    paint_depth(painter);
    for (const PlanRing& ring : slide_.source) paint_ring(painter, ring, colours_.muted);
    for (const PlanRing& ring : slide_.deposit.outline) paint_ring(painter, ring, colours_.text);
    const Descent& descent = slide_.run_out.crown_to_toe;
    painter.dashed(pixel(descent.from.x(), descent.from.y()), pixel(descent.to.x(), descent.to.y()), line_ * em_,
                   0.5 * em_, colours_.warn);
    paint_axes(painter);
    paint_legend(painter);
  }

 private:
  static constexpr double line_ = 0.1;
  static constexpr int steps_ = 20;  ///< of colour: cells of one step that lie in a row are painted at once

  void place(double width, double height) {
    const double left = left_of_map * em_, right = width - right_of_map(low_) * em_, bottom = below_map * em_,
                 top = height - above_map(titled_) * em_;
    const auto scale_of = [&](double across, double up) {
      return std::min((right - left) / across, (top - bottom) / up);
    };
    constexpr double much = 1.3;
    turned_ = ground_.up > ground_.across &&
              scale_of(ground_.up, ground_.across) > much * scale_of(ground_.across, ground_.up);
    if (turned_) std::swap(ground_.across, ground_.up);
    scale_ = scale_of(ground_.across, ground_.up);
    const double across = scale_ * ground_.across, up = scale_ * ground_.up;
    const double begin = left + (right - left - across) / 2;
    // In the middle of its room, as far as the key beside it has its own.
    const double key = (low_ ? 7.5 : 16) * em_, down = std::min((top - bottom - up) / 2, std::max(top - key, 0.0));
    map_ = {begin, top - down - up, begin + across, top - down};
  }

  PixelPoint pixel(double x, double y) const {
    const double east = scale_ * (x - ground_.west), north = scale_ * (y - ground_.south);
    return turned_ ? PixelPoint{map_.left + north, map_.top - east} : PixelPoint{map_.left + east, map_.bottom + north};
  }

  /// Of a depth: the middle of its step.
  int step_of(double depth) const { return std::clamp(static_cast<int>(steps_ * depth / scale_end_), 0, steps_ - 1); }
  static Rgb colour_of(int step) { return batlow().at((step + 0.5) / steps_); }

  void paint_depth(Painter& painter) const {
    const DepthGrid& grid = slide_.deposit.grid;
    for (int row = 0; row < grid.rows; ++row)
      for (int column = 0; column < grid.columns;) {
        if (!grid.covers(column, row)) {
          ++column;
          continue;
        }
        const int begin = column, step = step_of(grid.at(column, row));
        while (grid.covers(column, row) && step_of(grid.at(column, row)) == step) ++column;
        const PixelPoint a = pixel(grid.west + begin * grid.cell, grid.south + row * grid.cell);
        const PixelPoint b = pixel(grid.west + column * grid.cell, grid.south + (row + 1) * grid.cell);
        constexpr double lap = 0.4;  // pixels, over the neighbours: no paper is seen between them
        painter.fill(PixelRect{a.x, std::min(a.y, b.y), b.x + lap, std::max(a.y, b.y) + lap}, colour_of(step));
      }
  }

  void paint_ring(Painter& painter, const PlanRing& ring, Rgb colour) const {
    std::vector<PixelPoint> points;
    for (const auto& [x, y] : ring) points.push_back(pixel(x, y));
    points.push_back(points.front());
    painter.line(points, line_ * em_, colour);
  }

  /// Along a side of so many pixels, one every so many text heights.
  int most_ticks(double side, double apart) const { return std::clamp(static_cast<int>(side / (apart * em_)), 2, 7); }

  void paint_axes(Painter& painter) const {
    const auto frame = {PixelPoint{map_.left, map_.bottom}, PixelPoint{map_.right, map_.bottom},
                        PixelPoint{map_.right, map_.top}, PixelPoint{map_.left, map_.top},
                        PixelPoint{map_.left, map_.bottom}};
    painter.line(std::vector<PixelPoint>(frame), axis_width * em_, colours_.line);
    const Side east{picture_word("East, x") + " (m)", ground_.west},
        north{picture_word("North, y") + " (m)", ground_.south};
    paint_axis_below(painter, turned_ ? north : east);
    paint_axis_beside(painter, turned_ ? east : north);
  }

  /// What is counted along a side of the map, and from where, m.
  struct Side {
    std::string title;
    double begin;
  };

  void paint_axis_below(Painter& painter, const Side& side) const {
    const auto ticks = nice_ticks(side.begin, side.begin + ground_.across, most_ticks(map_.width(), 5));
    const auto labels = tick_labels(ticks);
    for (std::size_t i = 0; i < ticks.size(); ++i) {
      const double x = map_.left + scale_ * (ticks[i] - side.begin);
      painter.line({x, map_.bottom}, {x, map_.bottom - 0.4 * em_}, axis_width * em_, colours_.line);
      painter.text({x, map_.bottom - 0.7 * em_}, labels[i],
                   {.height = em_, .colour = colours_.text, .x = AlignX::centre, .y = AlignY::top});
    }
    painter.text({(map_.left + map_.right) / 2, map_.bottom - 2.1 * em_}, side.title,
                 {.height = em_, .colour = colours_.text, .x = AlignX::centre, .y = AlignY::top});
  }

  /// Upwards; downwards where the map is turned.
  void paint_axis_beside(Painter& painter, const Side& side) const {
    const auto ticks = nice_ticks(side.begin, side.begin + ground_.up, most_ticks(map_.height(), 2));
    const auto labels = tick_labels(ticks);
    double widest = 0;
    for (std::size_t i = 0; i < ticks.size(); ++i) {
      const double along = scale_ * (ticks[i] - side.begin), y = turned_ ? map_.top - along : map_.bottom + along;
      painter.line({map_.left, y}, {map_.left - 0.4 * em_, y}, axis_width * em_, colours_.line);
      painter.text({map_.left - 0.8 * em_, y}, labels[i],
                   {.height = em_, .colour = colours_.text, .x = AlignX::right, .y = AlignY::centre});
      widest = std::max(widest, text_width(labels[i], em_));
    }
    painter.text({map_.left - widest - 2.6 * em_, (map_.bottom + map_.top) / 2}, side.title,
                 {.height = em_, .colour = colours_.text, .x = AlignX::centre, .y = AlignY::top, .upwards = true});
  }

  /// Right of the map: which colour is which depth, and below it which line is what.
  void paint_legend(Painter& painter) const {
    const double left = map_.right + 2 * em_, top = map_.top - 1.8 * em_;
    const double bottom = top - std::clamp(map_.height() - (low_ ? 1.8 : 7) * em_, 4 * em_, 14 * em_);
    const DisplayUnit unit = display_unit("m", scale_end_);
    painter.text({left, map_.top}, picture_word("Depth") + " (" + unit.name + ")",
                 {.height = em_, .colour = colours_.text, .y = AlignY::top});
    for (int step = 0; step < steps_; ++step)
      painter.fill(PixelRect{left, bottom + (top - bottom) * step / steps_, left + 1.2 * em_,
                             bottom + (top - bottom) * (step + 1) / steps_},
                   colour_of(step));
    const auto ticks = nice_ticks(0, unit.factor * scale_end_, 5);
    const auto labels = tick_labels(ticks);
    for (std::size_t i = 0; i < ticks.size(); ++i)
      painter.text({left + 1.8 * em_, bottom + (top - bottom) * ticks[i] / (unit.factor * scale_end_)}, labels[i],
                   {.height = em_, .colour = colours_.text, .y = AlignY::centre});
    struct Line {
      std::string meaning;
      Rgb colour;
    };
    // Below the colours, or beside them where there is no room.
    const double key = low_ ? left + 6 * em_ : left;
    double y = low_ ? map_.top - 0.6 * em_ : bottom - 2.2 * em_;
    for (const Line& line :
         {Line{picture_word("deposit"), colours_.text}, Line{picture_word("the rock at rest"), colours_.muted},
          Line{picture_word("crown to toe"), colours_.warn}}) {
      if (line.colour == colours_.warn)
        painter.dashed({key, y}, {key + 2 * em_, y}, line_ * em_, 0.5 * em_, line.colour);
      else
        painter.line({key, y}, {key + 2 * em_, y}, line_ * em_, line.colour);
      painter.text({key + 2.6 * em_, y}, line.meaning, {.height = em_, .colour = colours_.text, .y = AlignY::centre});
      y -= 1.6 * em_;
    }
    if (turned_) paint_north(painter, {key, y});
  }

  /// An arrow to the right, and what it means.
  void paint_north(Painter& painter, const PixelPoint& at) const {
    const double tip = at.x + 2 * em_, half = 0.35 * em_;
    const PixelPoint head[] = {{tip - em_, at.y - half}, {tip, at.y}, {tip - em_, at.y + half}};
    painter.line(at, {tip - em_, at.y}, 1.5 * line_ * em_, colours_.text);
    painter.fill(head, colours_.text);
    painter.text({tip + 0.6 * em_, at.y}, picture_word("north"),
                 {.height = em_, .colour = colours_.text, .weight = FontWeight::semibold, .y = AlignY::centre});
  }

  const Slide& slide_;
  const ThemeColours& colours_;
  double em_;         ///< text height, pixels
  Ground ground_;     ///< across and up on paper: of turned ground from south to north, and from west to east
  double scale_end_;  ///< m
  bool low_ = false, titled_ = true, turned_ = false;
  double scale_ = 1;  ///< pixels a metre
  PixelRect map_;
};

}  // namespace

HistoryPlot front_plot(const Slide& slide, Theme theme) {
  HistoryPlot plot;
  plot.title = picture_word("Velocity of the front");
  plot.y_title = picture_word("Velocity, forward");
  plot.theme = theme;
  Series series{.name = picture_word("front"), .x = {}, .y = {}};
  double largest = 0;
  for (const FrontMoment& moment : slide.front) {
    series.x.push_back(moment.time);
    series.y.push_back(moment.velocity);
    largest = std::max(largest, std::abs(moment.velocity));
  }
  const DisplayUnit unit = display_unit("m/s", largest);
  plot.y_unit = unit.name;
  for (double& velocity : series.y) velocity *= unit.factor;
  plot.series.push_back(std::move(series));
  return plot;
}

double deposit_map_height(const Slide& slide, double width) {
  const Ground ground = ground_of(slide);
  const double em = text_height_for(width, width);
  const double shape = std::min(ground.across, ground.up) / std::max(ground.across, ground.up);
  const auto height_of = [&](bool low) {
    return shape * (width - (left_of_map + right_of_map(low)) * em) + (below_map + above_map(true)) * em;
  };
  const double low = std::max(height_of(true), least_height_of_titled * em);
  return low < least_height_of_high * em ? low : std::max(height_of(false), least_height_of_high * em);
}

Painting deposit_map(const Slide& slide, Theme theme) {
  if (slide.deposit.outline.empty()) throw std::invalid_argument("no rock has moved: there is no deposit to draw");
  return [slide, theme](Painter& painter, double width, double height) {
    DepositMap(slide, theme, width, height).paint(painter);
  };
}

}  // namespace talus
