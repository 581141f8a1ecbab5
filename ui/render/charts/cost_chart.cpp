#include "render/charts/cost_chart.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "render/charts/chart_layout.hpp"
#include "render/charts/log_axis.hpp"
#include "render/charts/painted_image.hpp"
#include "render/charts/tag_layout.hpp"
#include "render/paint/numbers.hpp"
#include "render/paint/picture_words.hpp"

namespace talus {
namespace {

// In text heights.
constexpr double row_height = 1.62, cost_margin = 1.4, tag_radius = 0.72;
constexpr double front_width = 0.16, cost_bar_width = 0.07;

std::string rounding_label() { return picture_word("rounding"); }

std::string text_of_error(const CostPoint& point) {
  return error_text(point.error) + (point.spread ? " ± " + error_text(*point.spread) : "");
}

/// A chart of a given size, laid out once and then painted.
class CostChart {
 public:
  CostChart(const CostPlot& plot, double width, double height)
      : plot_(plot), colours_(colours(plot.theme)), width_(width), height_(height) {
    by_cost_.resize(plot.points.size());
    std::iota(by_cost_.begin(), by_cost_.end(), std::size_t{0});
    std::stable_sort(by_cost_.begin(), by_cost_.end(),
                     [&](std::size_t a, std::size_t b) { return plot_.points[a].seconds < plot_.points[b].seconds; });
    const double lines = static_cast<double>(plot.points.size() + plot.notes.size()) + 8;
    em_ = std::max(
        9.0, std::min({height / 46, width / 92, (height - 2 * cost_margin * height / 46) / (lines * row_height)}));
    make_axes();
    place();
  }

  void paint(Painter& painter) const {
    paint_heading(painter);
    paint_grid(painter);
    paint_target(painter);
    paint_front(painter);
    paint_bars(painter);
    paint_tags(painter);
    paint_list(painter);
  }

 private:
  void make_axes() {
    constexpr double below_the_others = 10;
    std::vector<double> seconds, errors;
    if (plot_.target) errors.push_back(*plot_.target);
    for (const CostPoint& point : plot_.points) {
      seconds.push_back(point.seconds);
      if (point.error >= smallest_error) errors.push_back(point.error);
    }
    has_rounding_ = std::any_of(plot_.points.begin(), plot_.points.end(),
                                [](const CostPoint& point) { return point.error < smallest_error; });
    if (!errors.empty()) rounding_ = *std::min_element(errors.begin(), errors.end()) / below_the_others;
    if (has_rounding_) errors.push_back(rounding_);
    x_ = make_log_axis(seconds);
    y_ = make_log_axis(errors);
    if (!has_rounding_) return;
    const auto too_low = [&](double tick) { return tick < 2 * rounding_; };
    std::erase_if(y_.ticks, too_low);
    std::erase_if(y_.lesser_ticks, too_low);
  }

  double drawn_error(const CostPoint& point) const { return point.error < smallest_error ? rounding_ : point.error; }

  void place() {
    double label_width = text_width(picture_word("Setting"), em_), error_width = text_width(picture_word("Error"), em_),
           tick_width = 0;
    for (const CostPoint& point : plot_.points) {
      label_width = std::max(label_width, text_width(point.label, em_, weight_of(point)));
      error_width = std::max(error_width, text_width(text_of_error(point), em_, weight_of(point)));
    }
    for (const double tick : y_.ticks) tick_width = std::max(tick_width, text_width(error_tick_text(tick), em_));
    if (has_rounding_) tick_width = std::max(tick_width, text_width(rounding_label(), em_));
    error_column_ = width_ - cost_margin * em_ - 5.2 * em_;
    label_column_ = error_column_ - error_width - 1.4 * em_ - label_width;
    area_.left = cost_margin * em_ + 2.2 * em_ + tick_width + 0.8 * em_;
    area_.right = label_column_ - 2 * tag_radius * em_ - 2.2 * em_;
    area_.bottom = cost_margin * em_ + 3.2 * em_;
    area_.top = height_ - cost_margin * em_ - 4.6 * em_;
    for (const CostPoint& point : plot_.points) marks_.push_back(at(point.seconds, drawn_error(point)));
    tags_ = place_tags(marks_, tag_radius * em_, area_);
  }

  PixelPoint at(double seconds, double error) const {
    return {area_.left + area_.width() * x_.share(seconds), area_.bottom + area_.height() * y_.share(error)};
  }
  double clamped_y(double error) const {
    return std::clamp(at(x_.low, std::max(error, y_.low)).y, area_.bottom, area_.top);
  }
  Rgb colour_of(const CostPoint& point) const {
    return curve_palette(plot_.theme)[static_cast<std::size_t>(point.group)];
  }
  static FontWeight weight_of(const CostPoint& point) {
    return point.on_front ? FontWeight::semibold : FontWeight::regular;
  }
  TextStyle text(AlignX x = AlignX::left, AlignY y = AlignY::centre) const {
    return {.height = em_, .colour = colours_.text, .x = x, .y = y};
  }

  void paint_heading(Painter& painter) const {
    TextStyle style = text(AlignX::left, AlignY::top);
    style.height = 1.3 * em_;
    style.weight = FontWeight::semibold;
    painter.text({area_.left, height_ - cost_margin * em_}, plot_.title, style);
    double x = area_.left;
    const double y = area_.top + 1.2 * em_;
    for (std::size_t g = 0; g < plot_.groups.size(); ++g) {
      painter.disc({x + 0.4 * em_, y}, 0.4 * em_, curve_palette(plot_.theme)[g]);
      painter.text({x + 1.2 * em_, y}, plot_.groups[g], text());
      x += 1.2 * em_ + text_width(plot_.groups[g], em_) + 1.6 * em_;
    }
    painter.line({x, y}, {x + 2 * em_, y}, front_width * em_, colours_.muted);
    painter.text({x + 2.6 * em_, y}, picture_word("best for its cost"), text());
  }

  void paint_grid(Painter& painter) const {
    for (const double tick : y_.lesser_ticks)
      painter.line({area_.left, at(x_.low, tick).y}, {area_.right, at(x_.low, tick).y}, 0.5 * grid_width * em_,
                   colours_.grid);
    for (const double tick : x_.lesser_ticks)
      painter.line({at(tick, y_.low).x, area_.bottom}, {at(tick, y_.low).x, area_.top}, 0.5 * grid_width * em_,
                   colours_.grid);
    for (const double tick : y_.ticks) {
      const double y = at(x_.low, tick).y;
      painter.line({area_.left, y}, {area_.right, y}, grid_width * em_, colours_.frame);
      painter.text({area_.left - 0.7 * em_, y}, error_tick_text(tick), text(AlignX::right));
    }
    if (has_rounding_)
      painter.text({area_.left - 0.7 * em_, at(x_.low, rounding_).y}, rounding_label(), text(AlignX::right));
    for (const double tick : x_.ticks) {
      const double x = at(tick, y_.low).x;
      painter.line({x, area_.bottom}, {x, area_.top}, grid_width * em_, colours_.frame);
      painter.text({x, area_.bottom - 0.6 * em_}, tick_text(tick), text(AlignX::centre, AlignY::top));
    }
    painter.line({area_.left, area_.bottom}, {area_.left, area_.top}, axis_width * em_, colours_.line);
    painter.line({area_.left, area_.bottom}, {area_.right, area_.bottom}, axis_width * em_, colours_.line);
    painter.text({(area_.left + area_.right) / 2, cost_margin * em_},
                 picture_word("Processor time of solving") + " (s)", text(AlignX::centre, AlignY::bottom));
    TextStyle upwards = text(AlignX::centre, AlignY::top);
    upwards.upwards = true;
    painter.text({cost_margin * em_, (area_.bottom + area_.top) / 2}, plot_.error_title, upwards);
  }

  void paint_target(Painter& painter) const {
    if (!plot_.target) return;
    const double y = at(x_.low, *plot_.target).y;
    painter.dashed({area_.left, y}, {area_.right, y}, 1.6 * axis_width * em_, 0.5 * em_, colours_.pick);
    TextStyle style = text(AlignX::left, AlignY::bottom);
    style.colour = colours_.pick;
    style.weight = FontWeight::semibold;
    const std::string words = picture_word("target") + " " + error_text(*plot_.target);
    painter.text(clear_of_tags(y + 0.3 * em_, text_width(words, em_, FontWeight::semibold)), words, style);
  }

  /// Where words of this width, with their foot at `y`, hide no tag: as far to the right as that allows.
  PixelPoint clear_of_tags(double y, double width) const {
    const double rightmost = area_.right - width;
    for (double left = rightmost; left > area_.left + em_; left -= em_) {
      const bool clear = std::none_of(tags_.begin(), tags_.end(), [&](const PixelPoint& tag) {
        const double away = 1.5 * tag_radius * em_;
        return tag.x > left - away && tag.x < left + width + away && tag.y > y - away && tag.y < y + em_ + away;
      });
      if (clear) return {left, y};
    }
    return {rightmost, y};
  }

  void paint_front(Painter& painter) const {
    std::vector<PixelPoint> front;
    for (const std::size_t i : by_cost_)
      if (plot_.points[i].on_front) front.push_back(marks_[i]);
    painter.line(front, front_width * em_, colours_.muted, 0.55);
  }

  void paint_bars(Painter& painter) const {
    for (std::size_t i = 0; i < marks_.size(); ++i) {
      const CostPoint& point = plot_.points[i];
      if (point.uncertainty <= 0) continue;
      const double x = marks_[i].x, low = clamped_y(point.error - point.uncertainty),
                   high = clamped_y(point.error + point.uncertainty), half = 0.28 * em_;
      painter.line({x, low}, {x, high}, cost_bar_width * em_, colour_of(point), 0.7);
      for (const double end : {low, high})  // what leaves the chart has no end on it
        if (end > area_.bottom && end < area_.top)
          painter.line({x - half, end}, {x + half, end}, cost_bar_width * em_, colour_of(point), 0.7);
    }
  }

  void paint_tags(Painter& painter) const {
    for (std::size_t i = 0; i < tags_.size(); ++i) {
      if (tags_[i].x == marks_[i].x && tags_[i].y == marks_[i].y) continue;
      painter.line(marks_[i], tags_[i], axis_width * em_, colour_of(plot_.points[i]));
      painter.disc(marks_[i], 0.22 * em_, colour_of(plot_.points[i]));
    }
    for (std::size_t i = 0; i < tags_.size(); ++i) paint_tag(painter, tags_[i], plot_.points[i]);
  }

  void paint_tag(Painter& painter, PixelPoint at, const CostPoint& point) const {
    if (point.recommended) painter.disc(at, 1.35 * tag_radius * em_, colours_.pick);
    if (point.recommended) painter.disc(at, 1.15 * tag_radius * em_, colours_.surface);
    painter.disc(at, tag_radius * em_, colour_of(point));
    TextStyle style = text(AlignX::centre);
    style.height = 0.82 * em_;
    style.colour = colours_.surface;
    style.weight = FontWeight::semibold;
    painter.text(at, std::to_string(point.number), style);
  }

  void paint_list(Painter& painter) const {
    const double seconds_column = width_ - cost_margin * em_;
    double y = area_.top;
    TextStyle heading = text();
    heading.colour = colours_.muted;
    TextStyle to_the_right = heading;
    to_the_right.x = AlignX::right;
    painter.text({label_column_, y}, picture_word("Setting"), heading);
    painter.text({error_column_, y}, picture_word("Error"), to_the_right);
    painter.text({seconds_column, y}, picture_word("Seconds"), to_the_right);
    y -= 0.5 * row_height * em_;
    const double left = label_column_ - 2 * tag_radius * em_ - 0.6 * em_;
    painter.line({left, y}, {seconds_column, y}, axis_width * em_, colours_.line);
    y -= 0.7 * row_height * em_;
    for (const std::size_t i : by_cost_) {
      const CostPoint& point = plot_.points[i];
      paint_tag(painter, {left + tag_radius * em_, y}, point);
      TextStyle style = text();
      style.weight = weight_of(point);
      painter.text({label_column_, y}, point.label, style);
      style.x = AlignX::right;
      painter.text({error_column_, y}, text_of_error(point), style);
      painter.text({seconds_column, y}, format_number(point.seconds), style);
      y -= row_height * em_;
    }
    y -= 0.3 * row_height * em_;
    for (const std::string& note : plot_.notes)
      for (const std::string& line : wrapped(note, seconds_column - left, 0.92 * em_, FontWeight::regular)) {
        TextStyle style = text();
        style.height = 0.92 * em_;
        style.colour = colours_.muted;
        painter.text({left, y}, line, style);
        y -= 0.85 * row_height * em_;
      }
  }

  const CostPlot& plot_;
  const ThemeColours& colours_;
  double width_, height_, em_ = 16;
  std::vector<std::size_t> by_cost_;
  LogAxis x_, y_;
  bool has_rounding_ = false;
  double rounding_ = smallest_error;  ///< where errors that are rounding are drawn
  PixelRect area_;
  double label_column_ = 0, error_column_ = 0;
  std::vector<PixelPoint> marks_, tags_;
};

}  // namespace

Image draw_cost_chart(const CostPlot& plot, int width, int height) {
  if (plot.points.empty()) throw std::invalid_argument("a chart of costs needs a run");
  for (const CostPoint& point : plot.points)
    if (point.seconds <= 0 || static_cast<std::size_t>(point.group) >= plot.groups.size() ||
        plot.groups.size() > curve_palette(plot.theme).size())
      throw std::invalid_argument("run " + std::to_string(point.number) + " cannot be drawn");
  return painted_image(width, height, colours(plot.theme).surface,
                       [&](Painter& painter, double w, double h) { CostChart(plot, w, h).paint(painter); });
}

}  // namespace talus
