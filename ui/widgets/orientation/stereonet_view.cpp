#include "widgets/orientation/stereonet_view.hpp"

#include <QCoreApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "orientation/net_curves.hpp"
#include "render/stereonet/slope_key.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/text.hpp"
#include "widgets/kit/theme.hpp"
#include "widgets/orientation/net_artist.hpp"

namespace talus {

namespace {

constexpr double pole_reach = 9, ring = 7.5;  // pixels: how near a click must come; of the ring about what is selected
constexpr double farthest_word = 1.085, half_word = 14;  // radii; pixels
constexpr int drag_start = 5;                            // pixels
constexpr double key_sample = 22, key_line = 17;         // pixels
constexpr float zone_opacity = 0.3F;

/// Dip and dip direction of the plane whose pole is there; a dip above 90 beyond the rim.
PlaneAttitude rawPlane(const Vec3& pole) {
  const LineAttitude line = attitude_of(pole);
  return {90 - line.plunge, azimuth_within_circle(line.trend + 180)};
}

double tenth(double angle) { return std::round(10 * angle) / 10; }

}  // namespace

StereonetView::StereonetView() {
  setMinimumSize(320, 320);
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Stereonet: poles of the joints, lower hemisphere"));
}

void StereonetView::show(Stereonet net) {
  net_ = std::move(net);
  net_.window.reset();
  net_.selected.clear();
  drawn_ = draw_net(net_);
  std::erase_if(selected_, [this](std::size_t joint) { return joint >= net_.joints.size(); });
  picture_ = {};
  update();
}

void StereonetView::setSelected(std::vector<std::size_t> joints) {
  selected_ = std::move(joints);
  std::erase_if(selected_, [this](std::size_t joint) { return joint >= net_.joints.size(); });
  update();
}

void StereonetView::setWindow(const std::optional<SetWindow>& window) {
  window_ = window;
  update();
}

double StereonetView::radius() const { return (std::min(width(), height()) / 2.0 - half_word) / farthest_word; }

QPointF StereonetView::pointOf(const Vec3& line) const {
  const Vec2 place = projected(line, net_.projection);
  return centre() + radius() * QPointF(place.x(), -place.y());
}

QPointF StereonetView::pointOf(std::size_t joint) const { return pointOf(pole_of(net_.joints.at(joint).plane)); }

Vec3 StereonetView::lineAt(const QPointF& place) const {
  const QPointF from = (place - centre()) / radius();
  return unprojected({from.x(), -from.y()}, net_.projection);
}

std::optional<std::size_t> StereonetView::poleAt(const QPointF& place) const {
  std::optional<std::size_t> found;
  double least = pole_reach;
  for (std::size_t i = 0; i < net_.joints.size(); ++i) {
    const double away = QLineF(place, pointOf(i)).length();
    if (away > least) continue;
    least = away;
    found = i;
  }
  return found;
}

SetWindow StereonetView::windowBetween(const QPointF& from, const QPointF& to, bool cone) const {
  const Vec3 first = lineAt(from), second = lineAt(to);
  const PlaneAttitude a = rawPlane(first), b = rawPlane(second);
  if (cone) {
    const double angle = degrees(std::acos(std::clamp(first.dot(second), -1.0, 1.0)));
    return ConeWindow{upright({tenth(a.dip), tenth(a.dip_direction)}), tenth(std::min(angle, 90.0))};
  }
  // The shorter way round.
  const bool clockwise = azimuth_within_circle(b.dip_direction - a.dip_direction) <= 180;
  return RangeWindow{tenth(std::min(a.dip, b.dip)), tenth(std::max(a.dip, b.dip)),
                     tenth(clockwise ? a.dip_direction : b.dip_direction),
                     tenth(clockwise ? b.dip_direction : a.dip_direction)};
}

void StereonetView::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) pressed_ = event->position();
}

void StereonetView::mouseMoveEvent(QMouseEvent* event) {
  if (!pressed_) {
    setCursor(poleAt(event->position()) ? Qt::PointingHandCursor : Qt::CrossCursor);
    tell(event->globalPosition().toPoint(), event->position());
    return;
  }
  dragging_ = dragging_ || (event->position() - *pressed_).manhattanLength() >= drag_start;
  if (dragging_) setWindow(windowBetween(*pressed_, event->position(), event->modifiers().testFlag(Qt::ShiftModifier)));
}

void StereonetView::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !pressed_) return;
  const bool dragged = dragging_;
  dragging_ = false;
  pressed_.reset();
  if (dragged && window_)
    emit windowDrawn(*window_);
  else
    emit chosen(poleAt(event->position()));
}

void StereonetView::keyPressEvent(QKeyEvent* event) {
  const int way = event->key() == Qt::Key_Right ? 1 : event->key() == Qt::Key_Left ? -1 : 0;
  if (way == 0 || net_.joints.empty()) {
    QWidget::keyPressEvent(event);
    return;
  }
  const auto count = static_cast<std::ptrdiff_t>(net_.joints.size());
  const std::ptrdiff_t now = selected_.empty() ? (way > 0 ? -1 : count) : static_cast<std::ptrdiff_t>(selected_.back());
  emit chosen(static_cast<std::size_t>((now + way + count) % count));
}

void StereonetView::tell(const QPoint& where, const QPointF& place) {
  const auto joint = poleAt(place);
  if (!joint) {
    QToolTip::hideText();
    return;
  }
  const MeasuredJoint& one = net_.joints[*joint];
  const QString plane = numbers::orientation(one.plane.dip, one.plane.dip_direction);
  QToolTip::showText(where, tr("%1  %2\nNo. %3").arg(text(one.set), plane).arg(*joint + 1), this);
}

void StereonetView::resizeEvent(QResizeEvent*) { picture_ = {}; }

namespace {

void paintSample(QPainter& painter, const SlopeKeyRow& row, const QRectF& place) {
  using Sample = SlopeKeyRow::Sample;
  QColor colour = colourOf(row.colour);
  if (row.sample == Sample::cross) {
    NetArtist(painter, place.center(), 1)(NetMarker{{0, 0}, NetSymbol::cross, row.colour, row.colour, 1});
  } else if (row.sample == Sample::dot) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawEllipse(place.center(), 1.2, 1.2);
  } else if (row.sample == Sample::area) {
    colour.setAlphaF(zone_opacity);
    painter.fillRect(place.adjusted(0, 3, 0, -3), colour);
  } else {
    const Qt::PenStyle style = row.sample == Sample::dashes ? Qt::DashLine : Qt::SolidLine;
    painter.setPen(QPen(colour, row.width, style));
    painter.drawLine(QPointF(place.left(), place.center().y()), QPointF(place.right(), place.center().y()));
  }
}

}  // namespace

/// In the corner that the net leaves free.
void StereonetView::paintKey(QPainter& painter) const {
  double y = 0;
  painter.setFont(theme::font(theme::now().type.small));
  for (const SlopeKeyRow& row : slope_key(net_)) {
    paintSample(painter, row, {0, y, key_sample, key_line});
    painter.setPen(theme::colours().textMuted);
    painter.drawText(QRectF(key_sample + 8, y, width(), key_line), Qt::AlignVCenter,
                     text(row.words) + u' ' + text(row.value));
    y += key_line;
  }
}

void StereonetView::drawPicture() {
  picture_ = QPixmap(size() * devicePixelRatioF());
  picture_.setDevicePixelRatio(devicePixelRatioF());
  picture_.fill(theme::colours().surface);
  QPainter painter(&picture_);
  painter.setRenderHint(QPainter::Antialiasing);
  const NetArtist artist(painter, centre(), radius());
  for (const NetShape& shape : drawn_.shapes) std::visit(artist, shape);
  paintKey(painter);
}

void StereonetView::paintEvent(QPaintEvent*) {
  if (picture_.isNull()) drawPicture();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.drawPixmap(0, 0, picture_);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(theme::colours().pick, 2));
  for (const std::size_t joint : selected_) painter.drawEllipse(pointOf(joint), ring, ring);
  if (!window_) return;
  for (const NetCurve& curve : window_outline(*window_)) {
    QPolygonF points;
    for (const Vec3& pole : curve) points << pointOf(pole);
    painter.drawPolyline(points);
  }
}

}  // namespace talus
