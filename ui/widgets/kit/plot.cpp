#include "widgets/kit/plot.hpp"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "render/paint/numbers.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/text.hpp"
#include "widgets/kit/theme.hpp"

namespace talus {

namespace {

constexpr double least_left = 46, label_gap = 6, top_margin = 30, bottom_margin = 24;
constexpr double name_height = 13;
constexpr int tick_height = 10;

}  // namespace

std::optional<double> valueAt(const Curve& curve, double x) {
  if (curve.x.empty() || x < curve.x.front() || x > curve.x.back()) return std::nullopt;
  const auto after = static_cast<size_t>(std::lower_bound(curve.x.begin(), curve.x.end(), x) - curve.x.begin());
  if (after == 0 || curve.x[after] == x) return curve.y[after];
  const double share = (x - curve.x[after - 1]) / (curve.x[after] - curve.x[after - 1]);
  return curve.y[after - 1] + share * (curve.y[after] - curve.y[after - 1]);
}

Plot::Plot(const QString& title) : title_(title) {
  setMinimumSize(150, 90);
  setAccessibleName(title);
}

void Plot::setCurves(std::vector<Curve> curves, const QString& unit) {
  curves_ = std::move(curves);
  unit_ = unit;
  fitRanges();
  fitArea();
  update();
}

void Plot::redraw(std::vector<Curve> curves) {
  curves_ = std::move(curves);
  update();
}

void Plot::setCursor(std::optional<double> x) {
  if (x == cursor_) return;
  cursor_ = x;
  update();
}

void Plot::fitRanges() {
  x_ = {0, 0};
  y_ = {0, 0};
  for (const Curve& curve : curves_) {
    if (!curve.x.empty()) x_.high = std::max(x_.high, curve.x.back());
    for (double value : curve.y) {
      if (!std::isfinite(value)) continue;
      y_.low = std::min(y_.low, value);
      y_.high = std::max(y_.high, value);
    }
  }
  if (x_.high <= x_.low) x_.high = 1;
  if (y_.high <= y_.low) y_.high = 1;
  // Round ends: the ticks of a slightly longer axis.
  const double slack = 0.02 * (y_.high - y_.low);
  yTicks_ = nice_ticks(y_.low, y_.high + slack, 5);
  const double step = yTicks_.size() > 1 ? yTicks_[1] - yTicks_[0] : y_.high;
  y_.low = std::floor(y_.low / step + 1e-9) * step;
  y_.high = std::ceil(y_.high / step - 1e-9) * step;
  yTicks_ = nice_ticks(y_.low, y_.high, 6);
  xTicks_ = nice_ticks(x_.low, x_.high, 5);
}

void Plot::fitArea() {
  double names = 12;
  const QFontMetricsF metrics(theme::font(theme::now().type.small, QFont::Medium));
  for (const Curve& curve : curves_) names = std::max(names, metrics.horizontalAdvance(curve.name) + 14);
  names = std::min(names, width() * 0.3);
  double left = least_left;
  const QFontMetricsF numbers(theme::font(tick_height));
  for (const std::string& label : tick_labels(yTicks_))
    left = std::max(left, std::ceil(numbers.horizontalAdvance(text(label))) + 2 * label_gap);
  area_ = {left, top_margin, std::max(20.0, width() - left - names),
           std::max(20.0, height() - top_margin - bottom_margin)};
}

void Plot::resizeEvent(QResizeEvent*) { fitArea(); }

double Plot::xAt(double time) const { return area_.left() + (time - x_.low) / (x_.high - x_.low) * area_.width(); }

double Plot::yAt(double value) const { return area_.bottom() - (value - y_.low) / (y_.high - y_.low) * area_.height(); }

double Plot::timeAt(double x) const { return x_.low + (x - area_.left()) / area_.width() * (x_.high - x_.low); }

double Plot::valueAtHeight(double y) const {
  return y_.low + (area_.bottom() - y) / area_.height() * (y_.high - y_.low);
}

void Plot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), theme::colours().surface);
  painter.setRenderHint(QPainter::Antialiasing);
  drawHeading(painter);
  if (curves_.empty()) {
    painter.setPen(theme::colours().textFaint);
    painter.drawText(rect().adjusted(12, 28, -12, -8), Qt::AlignCenter | Qt::TextWordWrap, tr("Nothing to plot yet"));
    return;
  }
  drawAxes(painter);
  for (const Curve& curve : curves_) drawCurve(painter, curve);
  drawNames(painter);
  if (cursor_) drawCursor(painter);
}

void Plot::drawHeading(QPainter& painter) const {
  const QFont bold = theme::font(theme::now().type.small, QFont::DemiBold);
  painter.setFont(bold);
  painter.setPen(theme::colours().text);
  painter.drawText(QRectF(12, 6, width() - 24, 16), Qt::AlignVCenter, title_);
  const double after = 12 + QFontMetricsF(bold).horizontalAdvance(title_) + 6;
  painter.setFont(theme::font(theme::now().type.small));
  painter.setPen(theme::colours().textMuted);
  painter.drawText(QRectF(after, 6, width() - after, 16), Qt::AlignVCenter, unit_);
}

void Plot::drawAxes(QPainter& painter) const {
  const Colours& c = theme::colours();
  painter.setFont(theme::font(tick_height));
  const auto yLabels = tick_labels(yTicks_);
  const size_t every = area_.height() < 18.0 * static_cast<double>(yTicks_.size()) ? 2 : 1;
  for (size_t i = 0; i < yTicks_.size(); ++i) {
    const double y = yAt(yTicks_[i]);
    painter.setPen(QPen(std::abs(yTicks_[i]) < 1e-12 ? c.borderStrong : c.grid, 1));
    painter.drawLine(QPointF(area_.left(), y), QPointF(area_.right(), y));
    if (i % every != 0) continue;
    painter.setPen(c.textMuted);
    painter.drawText(QRectF(0, y - 8, area_.left() - label_gap, 16), Qt::AlignRight | Qt::AlignVCenter,
                     text(yLabels[i]));
  }
  painter.setPen(c.textMuted);
  const auto xLabels = tick_labels(xTicks_);
  const size_t skip = area_.width() < 42.0 * static_cast<double>(xTicks_.size()) ? 2 : 1;
  for (size_t i = 0; i < xTicks_.size(); i += skip) {
    QString label = text(xLabels[i]);
    if (i + skip >= xTicks_.size()) label += QStringLiteral(" s");
    const double half = painter.fontMetrics().horizontalAdvance(label) / 2.0 + 1;
    const double middle = std::min(xAt(xTicks_[i]), width() - half);  // the last one and its unit stay in the picture
    painter.drawText(QRectF(middle - half, area_.bottom() + 4, 2 * half, 14), Qt::AlignCenter, label);
    if (i == 0)
      painter.drawText(QRectF(0, area_.bottom() + 4, middle - half - 4, 14), Qt::AlignRight | Qt::AlignVCenter,
                       tr("Time"));
  }
}

void Plot::drawCurve(QPainter& painter, const Curve& curve) const {
  QPainterPath path;
  bool pen = false;
  // Within a pixel column only the extremes show, in the order in which they come.
  for (size_t i = 0; i < curve.x.size();) {
    const double column = std::floor(xAt(curve.x[i]));
    size_t low = i, high = i, end = i;
    for (; end < curve.x.size() && std::floor(xAt(curve.x[end])) == column; ++end) {
      if (curve.y[end] < curve.y[low]) low = end;
      if (curve.y[end] > curve.y[high]) high = end;
    }
    for (const size_t k : {i, std::min(low, high), std::max(low, high), end - 1}) {
      if (!std::isfinite(curve.y[k])) {
        pen = false;
        continue;
      }
      const QPointF at(xAt(curve.x[k]), yAt(curve.y[k]));
      if (pen)
        path.lineTo(at);
      else
        path.moveTo(at);
      pen = true;
    }
    i = end;
  }
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(theme::seriesColour(curve.colour), 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPath(path);
}

/// Names stand at the curves' ends, pushed apart where they would overlap: no key to look up.
void Plot::drawNames(QPainter& painter) const {
  struct Name {
    double y;
    const Curve* curve;
  };
  std::vector<Name> names;
  double right = 0;
  for (const Curve& curve : curves_) {
    if (curve.x.empty() || curve.name.isEmpty() || !std::isfinite(curve.y.back())) continue;
    names.push_back({yAt(curve.y.back()), &curve});
    right = std::max(right, xAt(curve.x.back()));
  }
  std::stable_sort(names.begin(), names.end(), [](const Name& a, const Name& b) { return a.y < b.y; });
  for (size_t i = 1; i < names.size(); ++i) names[i].y = std::max(names[i].y, names[i - 1].y + name_height);
  const double over = names.empty() ? 0 : names.back().y - (area_.bottom() - 6);
  for (size_t i = names.size(); over > 0 && i-- > 0;) {
    const double limit = i + 1 < names.size() ? names[i + 1].y - name_height : area_.bottom() - 6;
    names[i].y = std::min(names[i].y, limit);
  }
  painter.setFont(theme::font(theme::now().type.small, QFont::Medium));
  for (const Name& name : names) {
    painter.setPen(theme::seriesColour(name.curve->colour));
    painter.drawText(QRectF(right + 6, name.y - 8, width() - right - 8, 16), Qt::AlignVCenter, name.curve->name);
  }
}

void Plot::drawCursor(QPainter& painter) const {
  const Colours& c = theme::colours();
  const double x = xAt(*cursor_);
  if (x < area_.left() - 1 || x > area_.right() + 1) return;
  painter.setPen(QPen(c.accent, 1));
  painter.drawLine(QPointF(x, area_.top() - 4), QPointF(x, area_.bottom()));
  for (const Curve& curve : curves_) {
    const auto value = valueAt(curve, *cursor_);
    if (!value || !std::isfinite(*value)) continue;
    painter.setPen(QPen(c.surface, 1.5));
    painter.setBrush(theme::seriesColour(curve.colour));
    painter.drawEllipse(QPointF(x, yAt(*value)), 3.5, 3.5);
  }
  drawValuesAtCursor(painter);
}

/// In the heading, from the right edge, as many as there is room for.
void Plot::drawValuesAtCursor(QPainter& painter) const {
  constexpr double gap = 10;
  const QFont bold = theme::font(theme::now().type.small, QFont::DemiBold);
  const double heading = 12 + QFontMetricsF(bold).horizontalAdvance(title_ + unit_) + 2 * gap;
  painter.setFont(theme::font(theme::now().type.small, QFont::Medium));
  double right = width() - 12;
  for (size_t i = curves_.size(); i-- > 0;) {
    const auto value = valueAt(curves_[i], *cursor_);
    if (!value || !std::isfinite(*value)) continue;
    const QString words = QString::fromStdString(format_number(*value));
    const double room = painter.fontMetrics().horizontalAdvance(words);
    if (right - room < heading) return;
    painter.setPen(theme::seriesColour(curves_[i].colour));
    painter.drawText(QRectF(right - room, 6, room, 16), Qt::AlignVCenter | Qt::AlignRight, words);
    right -= room + gap;
  }
}

void Plot::chooseTime(double x) {
  if (curves_.empty()) return;
  const double share = std::clamp((x - area_.left()) / area_.width(), 0.0, 1.0);
  emit timeChosen(x_.low + share * (x_.high - x_.low));
}

void Plot::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) chooseTime(event->position().x());
}

void Plot::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons().testFlag(Qt::LeftButton)) chooseTime(event->position().x());
}

}  // namespace talus
