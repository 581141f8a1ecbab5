#include "render/charts/charts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "render/charts/chart_layout.hpp"
#include "render/charts/painted_image.hpp"
#include "render/paint/numbers.hpp"
#include "render/paint/picture_words.hpp"
#include "render/paint/value_range.hpp"
#include "results/monitor_value.hpp"

namespace talus {
namespace {

constexpr double text_row = 1.35;  ///< of text, in text heights, as all below
constexpr double curve_width = 0.13, mark_width = 0.06;

struct Axis {
  double low = 0, high = 1;
  std::vector<double> ticks;
  std::vector<std::string> labels;
};

/// The axis ends at ticks, or at the data's ends.
Axis make_axis(const ValueRange& data, int most_ticks, bool end_at_ticks) {
  Axis axis;
  ValueRange range = data.empty() ? ValueRange{0, 1} : data;
  if (range.high - range.low < 1e-12 * std::max(std::abs(range.high), 1e-300)) range = {range.low - 1, range.high + 1};
  axis.low = range.low;
  axis.high = range.high;
  axis.ticks = nice_ticks(range.low, range.high, most_ticks);
  if (end_at_ticks && axis.ticks.size() > 1) {
    const double step = axis.ticks[1] - axis.ticks[0];
    if (axis.ticks.front() - range.low > 1e-9 * step) axis.ticks.insert(axis.ticks.begin(), axis.ticks.front() - step);
    if (range.high - axis.ticks.back() > 1e-9 * step) axis.ticks.push_back(axis.ticks.back() + step);
    axis.low = axis.ticks.front();
    axis.high = axis.ticks.back();
  }
  axis.labels = tick_labels(axis.ticks);
  return axis;
}

std::string with_unit(const std::string& title, const std::string& unit) {
  return unit.empty() ? title : title + " (" + unit + ")";
}

/// A plot of a given size, laid out once and then painted.
class Chart {
 public:
  Chart(const HistoryPlot& plot, double width, double height) : plot_(plot), colours_(colours(plot.theme)) {
    em_ = std::max(11.0, std::min(height / 44, width / 66));
    make_axes();
    place(width, height);
  }

  void paint(Painter& painter) const {
    paint_title(painter);
    paint_axes(painter);
    paint_marks(painter);
    paint_curves(painter);
  }

 private:
  void make_axes() {
    ValueRange x, y;
    for (const Series& series : plot_.series) {
      x.include(series.x);
      y.include(series.y);
    }
    for (const EventMark& mark : plot_.marks) x.include(mark.x);
    constexpr double first_step = 0.02;  // of the whole: what begins with the first step is shown from the start
    if (x.low > 0 && x.low < first_step * x.high) x.low = 0;
    x_ = make_axis(x, 11, false);
    y_ = make_axis(y, 7, true);
  }

  void place(double width, double height) {
    double tick_label_width = 0, name_width = 0;
    for (const std::string& label : y_.labels) tick_label_width = std::max(tick_label_width, text_width(label, em_));
    for (const Series& series : plot_.series)
      name_width = std::max(name_width, text_width(series.name, em_, FontWeight::semibold));
    area_.left = 1.2 * em_ + text_row * em_ + 0.8 * em_ + tick_label_width + 0.8 * em_;
    area_.right = width - 1.2 * em_ - name_width - 1.2 * em_;
    area_.bottom = 1.2 * em_ + 2 * text_row * em_ + 1.2 * em_;
    title_at_ = {area_.left, height - 1.2 * em_};
    const double below_title = height - 1.2 * em_ - (plot_.title.empty() ? 0 : 2.2 * em_) - (has_key() ? 1.9 * em_ : 0);
    marks_ = plot_.marks;
    std::stable_sort(marks_.begin(), marks_.end(), [](const EventMark& a, const EventMark& b) { return a.x < b.x; });
    for (const EventMark& mark : marks_)
      labels_.push_back({.line = x_pixel(mark.x), .width = text_width(mark.label, label_height())});
    const int rows = arrange(labels_, 0.35 * em_, width - 1.2 * em_);
    area_.top = below_title - rows * text_row * em_ - (rows > 0 ? 0.4 * em_ : 0);
  }

  bool has_key() const {
    const auto reference = [](const EventMark& mark) { return mark.reference; };
    return std::any_of(plot_.marks.begin(), plot_.marks.end(), reference);
  }
  double label_height() const { return 0.9 * em_; }
  double x_pixel(double x) const { return area_.left + area_.width() * (x - x_.low) / (x_.high - x_.low); }
  double y_pixel(double y) const { return area_.bottom + area_.height() * (y - y_.low) / (y_.high - y_.low); }
  double mark_base(const MarkLabel& label) const { return area_.top + 0.4 * em_ + label.row * text_row * em_; }
  Rgb colour_of(std::size_t series) const { return curve_palette(plot_.theme)[series]; }

  void paint_title(Painter& painter) const {
    painter.text(title_at_, plot_.title,
                 {.height = 1.25 * em_, .colour = colours_.text, .weight = FontWeight::semibold, .y = AlignY::top});
    if (!has_key()) return;
    const double y = title_at_.y - (plot_.title.empty() ? 0 : 2.2 * em_) - 0.55 * em_;
    double x = area_.left;
    for (const bool reference : {false, true}) {
      paint_mark_line(painter, {x, y}, {x + 2.2 * em_, y}, reference);
      const std::string meaning = picture_word(reference ? "event in the reference" : "computed event");
      painter.text({x + 2.8 * em_, y}, meaning,
                   {.height = label_height(), .colour = colours_.muted, .y = AlignY::centre});
      x += 2.8 * em_ + text_width(meaning, label_height()) + 1.8 * em_;
    }
  }

  void paint_axes(Painter& painter) const {
    for (std::size_t i = 0; i < y_.ticks.size(); ++i) {
      const double y = y_pixel(y_.ticks[i]);
      const bool zero = y_.ticks[i] == 0;
      painter.line({area_.left, y}, {area_.right, y}, (zero ? axis_width : grid_width) * em_,
                   zero ? colours_.line : colours_.grid);
      painter.text({area_.left - 0.8 * em_, y}, y_.labels[i],
                   {.height = em_, .colour = colours_.text, .x = AlignX::right, .y = AlignY::centre});
    }
    painter.line({area_.left, area_.bottom}, {area_.left, area_.top}, axis_width * em_, colours_.line);
    painter.line({area_.left, area_.bottom}, {area_.right, area_.bottom}, axis_width * em_, colours_.line);
    for (std::size_t i = 0; i < x_.ticks.size(); ++i) {
      const double x = x_pixel(x_.ticks[i]);
      painter.line({x, area_.bottom}, {x, area_.bottom - 0.4 * em_}, axis_width * em_, colours_.line);
      painter.text({x, area_.bottom - 0.7 * em_}, x_.labels[i],
                   {.height = em_, .colour = colours_.text, .x = AlignX::centre, .y = AlignY::top});
    }
    painter.text({(area_.left + area_.right) / 2, 1.2 * em_}, with_unit(plot_.x_title, plot_.x_unit),
                 {.height = em_, .colour = colours_.text, .x = AlignX::centre});
    painter.text({1.2 * em_, (area_.bottom + area_.top) / 2}, with_unit(plot_.y_title, plot_.y_unit),
                 {.height = em_, .colour = colours_.text, .x = AlignX::centre, .y = AlignY::top, .upwards = true});
  }

  void paint_mark_line(Painter& painter, PixelPoint a, PixelPoint b, bool reference) const {
    if (reference)
      painter.dashed(a, b, mark_width * em_, 0.4 * em_, colours_.muted);
    else
      painter.line(a, b, mark_width * em_, colours_.muted);
  }

  void paint_marks(Painter& painter) const {
    for (std::size_t i = 0; i < marks_.size(); ++i) {
      const MarkLabel& label = labels_[i];
      const double base = mark_base(label);
      paint_mark_line(painter, {label.line, base + text_row * em_ * 0.85}, {label.line, area_.bottom},
                      marks_[i].reference);
    }
    for (std::size_t i = 0; i < marks_.size(); ++i) {
      const MarkLabel& label = labels_[i];
      const double base = mark_base(label);
      painter.fill(PixelRect{label.left, base, label.left + label.width, base + label_height()}, colours_.surface);
      painter.text({label.left, base}, marks_[i].label,
                   {.height = label_height(), .colour = marks_[i].reference ? colours_.muted : colours_.text});
    }
  }

  void paint_curves(Painter& painter) const {
    std::vector<double> ends;
    std::vector<PixelPoint> last_points;
    for (std::size_t s = 0; s < plot_.series.size(); ++s) {
      last_points.push_back(paint_curve(painter, plot_.series[s], colour_of(s)));
      ends.push_back(last_points.back().y);
    }
    const std::vector<double> heights = spread(ends, 1.3 * em_, area_.bottom, area_.top);
    for (std::size_t s = 0; s < heights.size(); ++s) {
      const PixelPoint name{area_.right + 1.2 * em_, heights[s]};
      painter.line({last_points[s].x + 0.2 * em_, last_points[s].y}, {name.x - 0.25 * em_, name.y}, grid_width * em_,
                   colour_of(s));
      painter.text(name, plot_.series[s].name,
                   {.height = em_, .colour = colour_of(s), .weight = FontWeight::semibold, .y = AlignY::centre});
    }
  }

  /// Returns where the curve ends.
  PixelPoint paint_curve(Painter& painter, const Series& series, Rgb colour) const {
    PixelPoint last{area_.right, area_.bottom};
    std::vector<PixelPoint> piece;
    const auto finish_piece = [&] {
      if (!piece.empty()) last = piece.back();
      painter.line(simplified(piece, 0.004 * em_), curve_width * em_, colour);
      piece.clear();
    };
    for (std::size_t i = 0; i < series.x.size(); ++i) {
      if (std::isfinite(series.x[i]) && std::isfinite(series.y[i]))
        piece.push_back({x_pixel(series.x[i]), y_pixel(series.y[i])});
      else
        finish_piece();
    }
    finish_piece();
    return last;
  }

  const HistoryPlot& plot_;
  const ThemeColours& colours_;
  double em_ = 16;  ///< text height, pixels
  Axis x_, y_;
  PixelRect area_;
  PixelPoint title_at_;
  std::vector<EventMark> marks_;  ///< by x
  std::vector<MarkLabel> labels_;
};

void check(const HistoryPlot& plot) {
  if (plot.series.empty() || plot.series.size() > curve_palette(plot.theme).size())
    throw std::invalid_argument("a plot shows one to six series");
  for (const Series& series : plot.series)
    if (series.x.size() != series.y.size())
      throw std::invalid_argument("series " + series.name + " has unequal numbers of x and y");
}

/// What a chart of a monitor's field calls itself, its axis and its curves.
struct Heading {
  std::string title_of_chart, title_of_axis;
  std::vector<std::string> components;
};

Heading heading_of(Quantity::Field field) {
  const std::vector<std::string> axes{picture_word("x east"), picture_word("y north"), picture_word("z up")};
  switch (field) {
    case Quantity::Field::velocity:
      return {picture_word("velocity"), picture_word("Velocity"), axes};
    case Quantity::Field::stress:
      return {picture_word("stress"), picture_word("Stress, tension positive"), {"xx", "yy", "zz", "xy", "yz", "zx"}};
    case Quantity::Field::displacement:
      break;
  }
  return {picture_word("displacement"), picture_word("Displacement"), axes};
}

}  // namespace

Painting chart_painting(const HistoryPlot& plot) {
  check(plot);
  return [plot](Painter& painter, double width, double height) { Chart(plot, width, height).paint(painter); };
}

Image draw_chart(const HistoryPlot& plot, int width, int height) {
  return painted_image(width, height, colours(plot.theme).surface, chart_painting(plot));
}

HistoryPlot monitor_plot(const std::string& monitor, int monitor_index, std::span<const HistoryRow> history,
                         Quantity::Field field) {
  const Heading heading = heading_of(field);
  HistoryPlot plot;
  plot.title = monitor + ": " + heading.title_of_chart;
  plot.y_title = heading.title_of_axis;
  double largest = 0;
  for (std::size_t component = 0; component < heading.components.size(); ++component) {
    Series series{.name = heading.components[component], .x = {}, .y = {}};
    for (const HistoryRow& row : history) {
      const MonitorSample& sample = row.monitors.at(static_cast<std::size_t>(monitor_index));
      series.x.push_back(row.time);
      series.y.push_back(field_value(sample, field)[static_cast<Eigen::Index>(component)]);
      if (std::isfinite(series.y.back())) largest = std::max(largest, std::abs(series.y.back()));
    }
    plot.series.push_back(std::move(series));
  }
  const DisplayUnit unit = display_unit(std::string(unit_of(field)), largest);
  plot.y_unit = unit.name;
  for (Series& series : plot.series)
    for (double& y : series.y) y *= unit.factor;
  return plot;
}

}  // namespace talus
