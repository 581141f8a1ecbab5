#include "widgets/kit/painting_view.hpp"

#include <QPainter>
#include <QPainterPath>
#include <utility>

#include "widgets/kit/theme.hpp"

namespace talus {

namespace {

QColor seen(Rgb colour, double opacity) {
  QColor result(colour.red, colour.green, colour.blue);
  result.setAlphaF(static_cast<float>(opacity));
  return result;
}

/// Paints with Qt's painter, whose y goes down.
class WidgetPainter final : public Painter {
 public:
  WidgetPainter(QPainter& painter, double height) : painter_(painter), height_(height) {}

 private:
  QPointF at(PixelPoint point) const { return {point.x, height_ - point.y}; }
  QPolygonF all(std::span<const PixelPoint> points) const {
    QPolygonF polygon;
    for (const PixelPoint& point : points) polygon << at(point);
    return polygon;
  }
  void draw_rectangle(const PixelRect& rect, Rgb colour, double opacity) override {
    painter_.fillRect(QRectF(at({rect.left, rect.top}), at({rect.right, rect.bottom})), seen(colour, opacity));
  }
  void draw_polygon(std::span<const PixelPoint> convex, Rgb colour, double opacity) override {
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(seen(colour, opacity));
    painter_.drawPolygon(all(convex));
  }
  void draw_line(std::span<const PixelPoint> points, double width, Rgb colour, double opacity) override {
    painter_.setPen(QPen(seen(colour, opacity), width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter_.drawPolyline(all(points));
  }
  void draw_disc(PixelPoint centre, double radius, Rgb colour) override {
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(seen(colour, 1));
    painter_.drawEllipse(at(centre), radius, radius);
  }
  void draw_text(PixelPoint place, std::string_view text, const TextStyle& style) override {
    const QString words = QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
    painter_.setFont(
        theme::font(qRound(style.height), style.weight == FontWeight::semibold ? QFont::DemiBold : QFont::Normal));
    painter_.setPen(seen(style.colour, 1));
    const double width = painter_.fontMetrics().horizontalAdvance(words);
    const double before = style.x == AlignX::left ? 0 : style.x == AlignX::centre ? width / 2 : width;
    painter_.save();
    painter_.translate(at(place));
    if (style.upwards) painter_.rotate(-90);
    painter_.drawText(QPointF(-before, style.height * baseline_below(style.y)), words);
    painter_.restore();
  }

  QPainter& painter_;
  double height_;
};

}  // namespace

PaintingView::PaintingView(const QString& name) {
  setAccessibleName(name);
  setMinimumSize(240, 120);
}

void PaintingView::setPainting(Painting painting) {
  painting_ = std::move(painting);
  update();
}

void PaintingView::paintEvent(QPaintEvent*) {
  if (!painting_) return;
  QPainter painter(this);
  painter.fillRect(rect(), theme::colours().surface);
  painter.setRenderHint(QPainter::Antialiasing);
  WidgetPainter painted(painter, height());
  painting_(painted, width(), height());
}

}  // namespace talus
