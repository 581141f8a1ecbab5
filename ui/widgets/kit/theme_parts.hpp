#pragma once

#include <QByteArray>
#include <QColor>
#include <QIcon>
#include <QProxyStyle>
#include <QString>

/// What theme.cpp is put together from.
namespace talus::theme {

/// The icon's SVG text with its strokes in one colour.
QByteArray recoloured(const QString& iconName, const QColor& colour);

/// The style sheet with every token in place.
QString styleSheet();

/// What a style sheet cannot say: metrics, times, the focus ring.
class TalusStyle : public QProxyStyle {
  Q_OBJECT
 public:
  TalusStyle();
  int pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override;
  int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                QStyleHintReturn* returned) const override;
  QIcon standardIcon(StandardPixmap icon, const QStyleOption* option, const QWidget* widget) const override;
  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
};

}  // namespace talus::theme
