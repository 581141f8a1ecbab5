#include "widgets/orientation/net_artist.hpp"

#include "widgets/kit/text.hpp"
#include "widgets/kit/theme.hpp"

namespace talus {

namespace {
constexpr double marker_radius = 3.6, rim_width = 0.9;  // pixels
}

QPolygonF NetArtist::outline(const std::vector<Vec2>& places) const {
  QPolygonF polygon;
  for (const Vec2& place : places) polygon << at(place);
  return polygon;
}

void NetArtist::operator()(const NetFill& shape) const {
  // Smoothed edges of neighbours let the ground shine through.
  painter_.setRenderHint(QPainter::Antialiasing, false);
  QColor colour = colourOf(shape.colour);
  colour.setAlphaF(static_cast<float>(shape.opacity));
  painter_.setPen(Qt::NoPen);
  painter_.setBrush(colour);
  painter_.drawConvexPolygon(outline(shape.corners));
  painter_.setRenderHint(QPainter::Antialiasing, true);
}

void NetArtist::operator()(const NetLine& shape) const {
  painter_.setPen(QPen(colourOf(shape.colour), shape.width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter_.drawPolyline(outline(shape.points));
}

void NetArtist::operator()(const NetMarker& shape) const {
  const QPointF middle = at(shape.at);
  for (const bool rim : {true, false})
    for (const std::vector<Vec2>& part : symbol_outline(shape.symbol)) {
      QPolygonF corners;
      for (const Vec2& corner : part) corners << middle + marker_radius * shape.size * QPointF(corner.x(), -corner.y());
      painter_.setPen(rim ? QPen(colourOf(shape.rim), 2 * rim_width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin)
                          : Qt::NoPen);
      painter_.setBrush(colourOf(rim ? shape.rim : shape.colour));
      painter_.drawConvexPolygon(corners);
    }
}

void NetArtist::operator()(const NetWord& shape) const {
  const Type& type = theme::now().type;
  painter_.setFont(shape.strong ? theme::font(type.title, QFont::DemiBold) : theme::font(type.small));
  painter_.setPen(colourOf(shape.colour));
  painter_.drawText(QRectF(at(shape.at) - QPointF(20, 10), QSizeF(40, 20)), Qt::AlignCenter, text(shape.text));
}

}  // namespace talus
