#include "widgets/forms/curve_editor.hpp"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "widgets/kit/numbers.hpp"
#include "widgets/kit/theme.hpp"

namespace talus {

namespace {

constexpr double hold = 8, dot = 3.5, chosen_dot = 5;  // pixels: of the hand, of a point
constexpr double grains = 200;                         // along an axis: what a hand tells apart

/// The nearest multiple of 1, 2 or 5 · 10ᵏ that a hand can mean where an axis spans so much.
double rounded(double value, double span) {
  const double rough = span / grains, power = std::pow(10, std::floor(std::log10(rough)));
  const double step = rough / power < 2 ? 2 * power : rough / power < 5 ? 5 * power : 10 * power;
  const double inverse = 1 / step;  // exact for steps below 1 to the last digit, which step itself is not
  return step < 1 ? std::round(value * inverse) / inverse : std::round(value / step) * step;
}

}  // namespace

CurveEditor::CurveEditor(const QString& title) : Plot(title) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setToolTip(
      tr("Drag a point, double-click a curve to put one in, Delete takes it away.\n"
         "Arrow keys choose a point, with Ctrl they move it."));
  setAccessibleDescription(toolTip());
}

QPointF CurveEditor::placeOf(const Point& point) const {
  const Curve& curve = curves()[static_cast<std::size_t>(point.curve)];
  const auto row = static_cast<std::size_t>(point.row);
  return {xAt(curve.x[row]), yAt(curve.y[row])};
}

CurveEditor::Point CurveEditor::pointAt(QPointF place) const {
  Point nearest;
  double least = hold;
  for (int c = 0; c < static_cast<int>(curves().size()); ++c)
    for (int row = 0; row < static_cast<int>(curves()[static_cast<std::size_t>(c)].x.size()); ++row) {
      const QPointF way = placeOf({c, row}) - place;
      const double away = std::hypot(way.x(), way.y());
      const bool preferred = away == least && c == chosen_.curve;  // of points that lie on each other
      if (away > least || (away == least && !preferred)) continue;
      least = away;
      nearest = {c, row};
    }
  return nearest;
}

void CurveEditor::choose(int row, int curve) {
  chosen_ = {};
  for (int c = 0; c < static_cast<int>(curves().size()); ++c)
    if (curves()[static_cast<std::size_t>(c)].colour == curve || c == 0) chosen_ = {c, row};
  if (curves().empty() || row < 0 || row >= static_cast<int>(curves()[0].x.size())) chosen_ = {};
  update();
}

QPointF CurveEditor::pointPlace(int row, int curve) const {
  for (int c = 0; c < static_cast<int>(curves().size()); ++c)
    if (curves()[static_cast<std::size_t>(c)].colour == curve) return placeOf({c, row});
  return {};
}

void CurveEditor::take(const Point& point) {
  chosen_ = point;
  update();
  if (point.isThere()) emit chosen(point.row, curves()[static_cast<std::size_t>(point.curve)].colour);
}

void CurveEditor::moveTo(double time, double value) {
  auto changed = curves();
  const auto row = static_cast<std::size_t>(chosen_.row);
  const Curve& curve = changed[static_cast<std::size_t>(chosen_.curve)];
  const double span = timeAt(area().right()) - timeAt(area().left()), gap = span / grains;
  const double low = row == 0 ? std::min(0.0, curve.x[0]) : curve.x[row - 1] + gap;
  const double high = row + 1 < curve.x.size() ? curve.x[row + 1] - gap : std::numeric_limits<double>::infinity();
  const double kept = low > high ? curve.x[row] : std::clamp(rounded(time, span), low, high);
  const double height = rounded(value, valueAtHeight(area().top()) - valueAtHeight(area().bottom()));
  for (Curve& each : changed) each.x[row] = kept;  // rows have one time for all
  changed[static_cast<std::size_t>(chosen_.curve)].y[row] = height;
  const int colour = curve.colour;
  redraw(std::move(changed));
  emit dragged(chosen_.row, colour, kept, height);
}

void CurveEditor::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  const Point point = pointAt(event->position());
  take(point);
  dragging_ = point.isThere();
  moved_ = false;
}

void CurveEditor::mouseMoveEvent(QMouseEvent* event) {
  if (!dragging_) {
    QWidget::setCursor(pointAt(event->position()).isThere() ? Qt::SizeAllCursor : Qt::ArrowCursor);
    return;
  }
  moved_ = true;
  moveTo(timeAt(event->position().x()), valueAtHeight(event->position().y()));
}

void CurveEditor::mouseReleaseEvent(QMouseEvent*) {
  if (!std::exchange(dragging_, false) || !moved_) return;
  const Curve& curve = curves()[static_cast<std::size_t>(chosen_.curve)];
  const auto row = static_cast<std::size_t>(chosen_.row);
  emit moved(chosen_.row, curve.colour, curve.x[row], curve.y[row]);
}

void CurveEditor::mouseDoubleClickEvent(QMouseEvent* event) {
  const double time = timeAt(event->position().x());
  for (const Curve& curve : curves()) {
    const auto value = valueAt(curve, time);
    if (!value || std::abs(yAt(*value) - event->position().y()) > hold) continue;
    if (pointAt(event->position()).isThere()) return;
    return emit inserted(rounded(time, timeAt(area().right()) - timeAt(area().left())));
  }
}

void CurveEditor::moveBy(int columns, int rows) {
  const Curve& curve = curves()[static_cast<std::size_t>(chosen_.curve)];
  const auto row = static_cast<std::size_t>(chosen_.row);
  const double along = (timeAt(area().right()) - timeAt(area().left())) / grains * 4;
  const double up = (valueAtHeight(area().top()) - valueAtHeight(area().bottom())) / grains * 4;
  moveTo(curve.x[row] + columns * along, curve.y[row] + rows * up);
  const Curve& now = curves()[static_cast<std::size_t>(chosen_.curve)];
  emit moved(chosen_.row, now.colour, now.x[row], now.y[row]);
}

void CurveEditor::keyPressEvent(QKeyEvent* event) {
  if (event->matches(QKeySequence::Paste)) return emit pasteWanted();
  static const std::map<int, std::array<int, 2>> ways{
      {Qt::Key_Left, {-1, 0}}, {Qt::Key_Right, {1, 0}}, {Qt::Key_Up, {0, 1}}, {Qt::Key_Down, {0, -1}}};
  const auto way = ways.find(event->key());
  if (curves().empty()) return Plot::keyPressEvent(event);
  if (way != ways.end()) {
    if (!chosen_.isThere()) return take({0, 0});
    const auto [columns, rows] = way->second;
    if (event->modifiers().testFlag(Qt::ControlModifier)) return moveBy(columns, rows);
    const int last = static_cast<int>(curves()[0].x.size()) - 1, count = static_cast<int>(curves().size());
    take({(chosen_.curve - rows + count) % count, std::clamp(chosen_.row + columns, 0, last)});
  } else if (chosen_.isThere() && (event->key() == Qt::Key_Delete || event->key() == Qt::Key_Backspace)) {
    emit removed(chosen_.row);
  } else {
    Plot::keyPressEvent(event);
  }
}

bool CurveEditor::event(QEvent* event) {
  // Arrow keys and Delete are this plot's while it has the keyboard, not the window's.
  if (event->type() == QEvent::ShortcutOverride) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    for (const int own : {Qt::Key_Left, Qt::Key_Right, Qt::Key_Up, Qt::Key_Down, Qt::Key_Delete, Qt::Key_Backspace})
      if (key == own) {
        event->accept();
        return true;
      }
  }
  return Plot::event(event);
}

void CurveEditor::focusInEvent(QFocusEvent* event) {
  Plot::focusInEvent(event);
  update();
}

void CurveEditor::focusOutEvent(QFocusEvent* event) {
  Plot::focusOutEvent(event);
  update();
}

void CurveEditor::paintEvent(QPaintEvent* event) {
  Plot::paintEvent(event);
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  for (int c = 0; c < static_cast<int>(curves().size()); ++c) {
    const Curve& curve = curves()[static_cast<std::size_t>(c)];
    painter.setPen(QPen(theme::colours().surface, 1.2));
    painter.setBrush(theme::seriesColour(curve.colour));
    for (int row = 0; row < static_cast<int>(curve.x.size()); ++row) painter.drawEllipse(placeOf({c, row}), dot, dot);
  }
  if (chosen_.isThere()) {
    painter.setPen(QPen(theme::colours().text, 1.6));
    painter.setBrush(theme::seriesColour(curves()[static_cast<std::size_t>(chosen_.curve)].colour));
    painter.drawEllipse(placeOf(chosen_), chosen_dot, chosen_dot);
    drawHint(painter);
  }
  if (hasFocus()) {
    painter.setPen(QPen(theme::colours().accent, 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
  }
}

/// What the chosen point says, in the plot's upper right corner: beside the pointer it would hide the curve.
void CurveEditor::drawHint(QPainter& painter) const {
  const Curve& curve = curves()[static_cast<std::size_t>(chosen_.curve)];
  const auto row = static_cast<std::size_t>(chosen_.row);
  const QString words =
      tr("%1: %2 s, %3 %4").arg(curve.name, numbers::figure(curve.x[row], 5), numbers::figure(curve.y[row], 5), unit());
  painter.setFont(theme::font(theme::now().type.small));
  painter.setPen(theme::colours().textMuted);
  painter.drawText(QRectF(12, 6, width() - 20, 16), Qt::AlignRight | Qt::AlignVCenter, words);
}

}  // namespace talus
