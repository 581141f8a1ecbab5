#include "widgets/geometry/section_plot.hpp"

#include <QKeyEvent>
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

constexpr double axis_left = 56, axis_bottom = 34, axis_top = 14, axis_right = 18;  // pixels
constexpr double hand_reach = 8;    // pixels: what a hand means by "on it"
constexpr double handle = 4;        // pixels, half a handle's side
constexpr double usual_grid = 0.5;  // m
constexpr double notch = 0.85;

double distance(QPointF a, QPointF b) { return std::hypot(a.x() - b.x(), a.y() - b.y()); }

/// The point of a line from a to b that is nearest to p.
QPointF nearestOn(QPointF a, QPointF b, QPointF p) {
  const QPointF way = b - a;
  const double length = QPointF::dotProduct(way, way);
  const double share = length > 0 ? std::clamp(QPointF::dotProduct(p - a, way) / length, 0.0, 1.0) : 0;
  return a + share * way;
}

}  // namespace

SectionPlot::SectionPlot() {
  setMinimumSize(360, 260);
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Profile of the section"));
}

void SectionPlot::setCorners(const Corners& corners) {
  const bool first = corners_.empty();
  corners_ = corners;
  if (chosen_ >= static_cast<int>(corners_.size())) chosen_ = -1;
  if (first || (fitted_ && !dragging_)) fit();
  update();
}

void SectionPlot::setRefused(bool refused) {
  refused_ = refused;
  update();
}

QRectF SectionPlot::area() const {
  return {axis_left, axis_top, std::max(1.0, width() - axis_left - axis_right),
          std::max(1.0, height() - axis_top - axis_bottom)};
}

void SectionPlot::fit() {
  fitted_ = true;
  if (corners_.empty()) return;
  auto low = corners_[0], high = low;
  for (const auto& corner : corners_)
    for (std::size_t i = 0; i < 2; ++i) {
      low[i] = std::min(low[i], corner[i]);
      high[i] = std::max(high[i], corner[i]);
    }
  constexpr double room = 1.16;  // times what is drawn
  const double across = std::max(1e-6, high[0] - low[0]), up = std::max(1e-6, high[1] - low[1]);
  middle_ = {(low[0] + high[0]) / 2, (low[1] + high[1]) / 2};
  pixelsPerMetre_ = std::min(area().width() / across, area().height() / up) / room;
  update();
}

QPointF SectionPlot::pixelOf(const std::array<double, 2>& corner) const {
  return area().center() + pixelsPerMetre_ * QPointF(corner[0] - middle_[0], middle_[1] - corner[1]);
}

std::array<double, 2> SectionPlot::metresOf(QPointF pixel) const {
  const QPointF away = (pixel - area().center()) / pixelsPerMetre_;
  return {middle_[0] + away.x(), middle_[1] - away.y()};
}

double SectionPlot::grid() const {
  const double narrow = area().width() / pixelsPerMetre_ / 20;  // a twentieth of what is seen
  return narrow > usual_grid ? usual_grid : round_down(std::max(narrow, 1e-6));
}

std::array<double, 2> SectionPlot::snapped(std::array<double, 2> corner) const {
  for (double& value : corner) value = std::round(value / grid()) * grid();
  return corner;
}

int SectionPlot::cornerAt(QPointF pixel) const {
  int nearest = -1;
  double least = hand_reach;
  for (std::size_t i = 0; i < corners_.size(); ++i)
    if (const double away = distance(pixelOf(corners_[i]), pixel); away <= least) {
      least = away;
      nearest = static_cast<int>(i);
    }
  return nearest;
}

std::optional<std::pair<int, QPointF>> SectionPlot::edgeAt(QPointF pixel) const {
  std::optional<std::pair<int, QPointF>> found;
  double least = hand_reach;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const QPointF on = nearestOn(pixelOf(corners_[i]), pixelOf(corners_[(i + 1) % corners_.size()]), pixel);
    if (const double away = distance(on, pixel); away <= least) {
      least = away;
      found = {static_cast<int>(i), on};
    }
  }
  return found;
}

void SectionPlot::resizeEvent(QResizeEvent*) {
  if (fitted_) fit();
}

void SectionPlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), theme::colours().surface);
  painter.setRenderHint(QPainter::Antialiasing);
  drawAxes(painter);
  painter.setClipRect(area());
  drawProfile(painter);
  drawHandles(painter);
}

void SectionPlot::drawAxes(QPainter& painter) const {
  const Colours& c = theme::colours();
  const QRectF inside = area();
  const auto low = metresOf(inside.bottomLeft()), high = metresOf(inside.topRight());
  painter.setFont(theme::font(theme::now().type.small));
  const auto across = nice_ticks(low[0], high[0], std::max(2, static_cast<int>(inside.width() / 70)));
  const auto names = tick_labels(across);
  for (std::size_t i = 0; i < across.size(); ++i) {
    const double x = pixelOf({across[i], 0}).x();
    painter.setPen(QPen(std::abs(across[i]) < 1e-9 ? c.borderStrong : c.grid, 1));
    painter.drawLine(QPointF(x, inside.top()), QPointF(x, inside.bottom()));
    painter.setPen(c.textMuted);
    painter.drawText(QRectF(x - 35, inside.bottom() + 2, 70, 14), Qt::AlignCenter, text(names[i]));
  }
  const auto upwards = nice_ticks(low[1], high[1], std::max(2, static_cast<int>(inside.height() / 44)));
  const auto levels = tick_labels(upwards);
  for (std::size_t i = 0; i < upwards.size(); ++i) {
    const double y = pixelOf({0, upwards[i]}).y();
    painter.setPen(QPen(std::abs(upwards[i]) < 1e-9 ? c.borderStrong : c.grid, 1));
    painter.drawLine(QPointF(inside.left(), y), QPointF(inside.right(), y));
    painter.setPen(c.textMuted);
    painter.drawText(QRectF(0, y - 8, axis_left - 8, 16), Qt::AlignRight | Qt::AlignVCenter, text(levels[i]));
  }
  painter.setPen(c.textMuted);
  painter.drawText(QRectF(inside.left(), inside.bottom() + 16, inside.width(), 16), Qt::AlignCenter,
                   tr("distance d, m"));
  painter.save();
  painter.translate(11, inside.center().y());
  painter.rotate(-90);
  painter.drawText(QRectF(-80, -8, 160, 16), Qt::AlignCenter, tr("height h, m"));
  painter.restore();
}

void SectionPlot::drawProfile(QPainter& painter) const {
  if (corners_.empty()) return;
  QPainterPath outline(pixelOf(corners_[0]));
  for (std::size_t i = 1; i < corners_.size(); ++i) outline.lineTo(pixelOf(corners_[i]));
  outline.closeSubpath();
  const Colours& c = theme::colours();
  QColor rock = refused_ ? c.error : c.rock;
  rock.setAlphaF(refused_ ? 0.15F : 0.55F);
  painter.setBrush(rock);
  painter.setPen(QPen(refused_ ? c.error : c.text, 1.4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPath(outline);
}

void SectionPlot::drawHandles(QPainter& painter) const {
  const Colours& c = theme::colours();
  const int under = dragging_ ? chosen_ : cornerAt(pointer_);
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const QPointF at = pixelOf(corners_[i]);
    const bool marked = static_cast<int>(i) == chosen_ || static_cast<int>(i) == under;
    painter.setPen(QPen(marked ? c.pick : c.text, marked ? 2 : 1.2));
    painter.setBrush(static_cast<int>(i) == chosen_ ? c.pick : c.raised);
    painter.drawRect(QRectF(at - QPointF(handle, handle), QSizeF(2 * handle, 2 * handle)));
  }
  if (under < 0 && !panning_) {
    if (const auto edge = edgeAt(pointer_)) {  // where a click makes a corner
      painter.setPen(QPen(c.pick, 1.4));
      painter.setBrush(Qt::NoBrush);
      painter.drawEllipse(edge->second, handle + 1, handle + 1);
    }
    return;
  }
  if (under < 0) return;
  const auto& corner = corners_[static_cast<std::size_t>(under)];
  const QString words = QStringLiteral("%1, %2 m").arg(numbers::figure(corner[0], 6), numbers::figure(corner[1], 6));
  painter.setFont(theme::font(theme::now().type.small, QFont::Medium));
  QRectF card(pixelOf(corner) + QPointF(12, -26), QSizeF(painter.fontMetrics().horizontalAdvance(words) + 12, 20));
  if (card.right() > area().right()) card.moveRight(pixelOf(corner).x() - 12);
  if (card.top() < area().top()) card.moveTop(pixelOf(corner).y() + 8);
  painter.setPen(c.overlayBorder);
  painter.setBrush(c.overlay);
  painter.drawRoundedRect(card, 4, 4);
  painter.setPen(c.text);
  painter.drawText(card, Qt::AlignCenter, words);
}

void SectionPlot::mousePressEvent(QMouseEvent* event) {
  pointer_ = event->position();
  moved_ = false;
  if (event->button() == Qt::MiddleButton) {
    panning_ = true;
    return;
  }
  if (event->button() != Qt::LeftButton) return;
  chosen_ = cornerAt(pointer_);
  if (chosen_ < 0)
    if (const auto edge = edgeAt(pointer_)) {
      auto with = corners_;
      chosen_ = edge->first + 1;
      with.insert(with.begin() + chosen_, metresOf(edge->second));
      corners_ = with;
      moved_ = true;
    }
  dragging_ = chosen_ >= 0;
  panning_ = !dragging_;
  if (moved_) emit edited(Corners(corners_), false);
  update();
}

void SectionPlot::mouseMoveEvent(QMouseEvent* event) {
  const QPointF by = event->position() - pointer_;
  pointer_ = event->position();
  if (panning_) {
    fitted_ = false;
    middle_ = {middle_[0] - by.x() / pixelsPerMetre_, middle_[1] + by.y() / pixelsPerMetre_};
  } else if (dragging_) {
    moved_ = true;
    const auto at = metresOf(pointer_);
    corners_[static_cast<std::size_t>(chosen_)] = event->modifiers().testFlag(Qt::ShiftModifier) ? snapped(at) : at;
    emit edited(Corners(corners_), false);
  }
  setCursor(dragging_ || cornerAt(pointer_) >= 0 ? Qt::SizeAllCursor
            : edgeAt(pointer_)                   ? Qt::CrossCursor
                                                 : Qt::ArrowCursor);
  update();
}

void SectionPlot::mouseReleaseEvent(QMouseEvent*) {
  const bool changed = dragging_ && moved_;
  dragging_ = panning_ = false;
  if (changed) emit edited(Corners(corners_), true);
  update();
}

void SectionPlot::mouseDoubleClickEvent(QMouseEvent* event) {
  if (cornerAt(event->position()) < 0) fit();
}

void SectionPlot::wheelEvent(QWheelEvent* event) {
  fitted_ = false;
  const auto under = metresOf(event->position());
  pixelsPerMetre_ /= std::pow(notch, event->angleDelta().y() / 120.0);
  const auto now = metresOf(event->position());
  middle_ = {middle_[0] + under[0] - now[0], middle_[1] + under[1] - now[1]};
  update();
}

/// Arrows and Delete are this widget's while it has the keyboard, not the window's.
bool SectionPlot::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && chosen_ >= 0) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Delete || key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up ||
        key == Qt::Key_Down)
      event->accept();
  }
  return QWidget::event(event);
}

void SectionPlot::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
      return takeAway();
    case Qt::Key_Left:
      return nudge(-grid(), 0);
    case Qt::Key_Right:
      return nudge(grid(), 0);
    case Qt::Key_Up:
      return nudge(0, grid());
    case Qt::Key_Down:
      return nudge(0, -grid());
    default:
      QWidget::keyPressEvent(event);
  }
}

void SectionPlot::takeAway() {
  if (chosen_ < 0) return;
  Corners fewer = corners_;
  fewer.erase(fewer.begin() + chosen_);
  chosen_ = -1;
  emit edited(fewer, true);
}

void SectionPlot::nudge(double distance, double height) {
  if (chosen_ < 0) return;
  Corners changed = corners_;
  auto& corner = changed[static_cast<std::size_t>(chosen_)];
  corner = {corner[0] + distance, corner[1] + height};
  emit edited(changed, true);
}

}  // namespace talus
