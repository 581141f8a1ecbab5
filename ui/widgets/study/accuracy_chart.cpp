#include "widgets/study/accuracy_chart.hpp"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "render/charts/cost_chart.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/text.hpp"
#include "widgets/kit/theme.hpp"

namespace talus {

namespace {

constexpr double radius = 4.5, point_reach = 12;             // pixels: of a point, and how near a click must come
constexpr double shortest_seconds = 1e-4;                    // the processor's clock tells nothing shorter
constexpr int left = 78, right = 16, top = 30, bottom = 42;  // pixels beside the axes

}  // namespace

AccuracyChart::AccuracyChart() {
  setMinimumSize(360, 240);
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Error against processor time of the runs"));
}

void AccuracyChart::show(const AccuracyStudy& study) {
  points_.clear();
  std::vector<double> seconds, errors;
  for (std::size_t i = 0; i < study.rows.size(); ++i) {
    const AccuracyRow& row = study.rows[i];
    if (!row.error) continue;
    Point point{static_cast<int>(i),
                {},
                std::max(row.run->cpu_seconds, shortest_seconds),
                std::max(*row.error, smallest_error),
                row.error_estimate,
                row.pareto};
    point.words = tr("Run %1: %2\n%3 s, error %4")
                      .arg(i)
                      .arg(text(row.label), numbers::significant(point.seconds), text(error_text(*row.error)));
    seconds.push_back(point.seconds);
    errors.push_back(point.error);
    points_.push_back(std::move(point));
  }
  std::stable_sort(points_.begin(), points_.end(),
                   [](const Point& a, const Point& b) { return a.seconds < b.seconds; });
  target_ = study.target;
  if (target_) errors.push_back(*target_);
  seconds_ = make_log_axis(seconds);
  errors_ = make_log_axis(errors);
  update();
}

void AccuracyChart::setChosen(std::optional<int> run) {
  chosen_ = run;
  update();
}

QRectF AccuracyChart::area() const { return QRectF(rect()).adjusted(left, top, -right, -bottom); }

QPointF AccuracyChart::at(double seconds, double error) const {
  const QRectF inside = area();
  return {inside.left() + inside.width() * seconds_.share(seconds),
          inside.bottom() - inside.height() * errors_.share(error)};
}

std::optional<QPointF> AccuracyChart::pointOf(int run) const {
  for (const Point& point : points_)
    if (point.run == run) return at(point.seconds, point.error);
  return std::nullopt;
}

const AccuracyChart::Point* AccuracyChart::nearest(const QPointF& place) const {
  const Point* found = nullptr;
  double least = point_reach;
  for (const Point& point : points_) {
    const double away = QLineF(place, at(point.seconds, point.error)).length();
    if (away > least) continue;
    least = away;
    found = &point;
  }
  return found;
}

void AccuracyChart::mousePressEvent(QMouseEvent* event) {
  const Point* point = nearest(event->position());
  if (point && event->button() == Qt::LeftButton) emit chosen(point->run);
}

void AccuracyChart::mouseMoveEvent(QMouseEvent* event) {
  const Point* point = nearest(event->position());
  setCursor(point ? Qt::PointingHandCursor : Qt::ArrowCursor);
  if (point)
    QToolTip::showText(event->globalPosition().toPoint(), point->words, this);
  else
    QToolTip::hideText();
}

void AccuracyChart::keyPressEvent(QKeyEvent* event) {
  const int way = event->key() == Qt::Key_Right ? 1 : event->key() == Qt::Key_Left ? -1 : 0;
  if (way == 0 || points_.empty()) {
    QWidget::keyPressEvent(event);
    return;
  }
  const auto now = std::find_if(points_.begin(), points_.end(), [&](const Point& one) { return one.run == chosen_; });
  const auto place = now == points_.end() ? 0 : now - points_.begin() + way;
  emit chosen(points_[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(place, 0, std::ssize(points_) - 1))].run);
}

void AccuracyChart::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(theme::font(theme::now().type.small));
  drawAxes(painter);
  drawTarget(painter);
  drawPoints(painter);
}

void AccuracyChart::drawAxes(QPainter& painter) const {
  const Colours& c = theme::colours();
  const QRectF inside = area();
  painter.setPen(QPen(c.grid, 1));
  for (const double tick : seconds_.ticks) painter.drawLine(QLineF(at(tick, errors_.low), at(tick, errors_.high)));
  for (const double tick : errors_.ticks) painter.drawLine(QLineF(at(seconds_.low, tick), at(seconds_.high, tick)));
  painter.setPen(QPen(c.borderStrong, 1));
  painter.drawLine(inside.bottomLeft(), inside.bottomRight());
  painter.drawLine(inside.bottomLeft(), inside.topLeft());
  painter.setPen(c.textMuted);
  for (const double tick : seconds_.ticks)
    painter.drawText(QRectF(at(tick, errors_.low) + QPointF(-30, 4), QSizeF(60, 16)), Qt::AlignCenter,
                     text(tick_text(tick)));
  for (const double tick : errors_.ticks)
    painter.drawText(QRectF(at(seconds_.low, tick) + QPointF(-left, -8), QSizeF(left - 8, 16)),
                     Qt::AlignRight | Qt::AlignVCenter, text(error_tick_text(tick)));
  painter.drawText(QRectF(inside.left(), inside.bottom() + 20, inside.width(), 18), Qt::AlignCenter,
                   tr("Processor time of solving, s"));
  painter.drawText(QRectF(inside.left() - left + 12, 6, inside.width() + left, 18), Qt::AlignLeft | Qt::AlignVCenter,
                   tr("Error, relative"));
  double end = inside.right();
  for (const auto& [best, words] : {std::pair(false, tr("others")), {true, tr("best for its cost")}}) {
    const double width = painter.fontMetrics().horizontalAdvance(words);
    painter.setPen(c.textMuted);
    painter.drawText(QRectF(end - width, 6, width, 18), Qt::AlignVCenter, words);
    drawDot(painter, QPointF(end - width - 12, 15), best);
    end -= width + 36;
  }
}

void AccuracyChart::drawDot(QPainter& painter, const QPointF& place, bool best) const {
  const Colours& c = theme::colours();
  painter.setPen(QPen(best ? c.accent : c.textMuted, 1.5));
  painter.setBrush(best ? c.accent : c.surface);
  painter.drawEllipse(place, radius, radius);
}

void AccuracyChart::drawTarget(QPainter& painter) const {
  if (!target_) return;
  const QPointF from = at(seconds_.low, *target_), to = at(seconds_.high, *target_);
  painter.setPen(QPen(theme::colours().pick, 1.5, Qt::DashLine));
  painter.drawLine(from, to);
  painter.drawText(QRectF(to + QPointF(-160, -18), QSizeF(158, 16)), Qt::AlignRight | Qt::AlignVCenter,
                   tr("target %1").arg(text(error_text(*target_))));
}

void AccuracyChart::drawPoints(QPainter& painter) const {
  const Colours& c = theme::colours();
  QPolygonF front;
  for (const Point& point : points_)
    if (point.best) front << at(point.seconds, point.error);
  painter.setPen(QPen(c.accent, 1.5));
  painter.drawPolyline(front);
  for (const Point& point : points_) {
    const QPointF place = at(point.seconds, point.error);
    if (point.uncertainty > 0) {
      const double high = at(point.seconds, std::min(point.error + point.uncertainty, errors_.high)).y();
      const double low = at(point.seconds, std::max(point.error - point.uncertainty, errors_.low)).y();
      painter.setPen(QPen(point.best ? c.accent : c.borderStrong, 1));
      painter.setOpacity(0.45);
      painter.drawLine(QLineF(place.x(), low, place.x(), high));
      painter.setOpacity(1);
    }
    drawDot(painter, place, point.best);
    if (chosen_ != point.run) continue;
    painter.setPen(QPen(c.pick, 2));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(place, radius + 4, radius + 4);
  }
}

}  // namespace talus
