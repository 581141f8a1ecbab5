#include <QFile>
#include <QIconEngine>
#include <QPainter>
#include <QSvgRenderer>

#include "widgets/kit/theme.hpp"
#include "widgets/kit/theme_parts.hpp"

namespace talus::theme {

QByteArray recoloured(const QString& iconName, const QColor& colour) {
  QFile file(QStringLiteral(":/icons/%1.svg").arg(iconName));
  if (!file.open(QIODevice::ReadOnly)) {
    qWarning("no icon named %s", qPrintable(iconName));
    return {};
  }
  return file.readAll().replace("currentColor", colour.name().toLatin1());
}

QColor toneColour(Tone tone) {
  const Colours& c = colours();
  switch (tone) {
    case Tone::text:
      return c.text;
    case Tone::muted:
      return c.textMuted;
    case Tone::accent:
      return c.accentText;
    case Tone::onAccent:
      return c.onAccent;
    case Tone::ok:
      return c.ok;
    case Tone::warn:
      return c.warn;
    case Tone::error:
      return c.error;
  }
  return c.text;
}

namespace {

class ToneEngine : public QIconEngine {
 public:
  ToneEngine(QString name, Tone tone) : name_(std::move(name)), tone_(tone) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
    const bool quiet = tone_ == Tone::muted;
    QColor colour = toneColour(tone_);
    double opacity = 1;
    if (mode == QIcon::Disabled) {
      colour = colours().textFaint;
      opacity = 0.55;
    } else if (quiet && state == QIcon::On) {
      colour = colours().accentText;
    } else if (quiet && mode == QIcon::Active) {
      colour = colours().text;
    }
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setOpacity(painter->opacity() * opacity);
    QSvgRenderer(recoloured(name_, colour)).render(painter, rect);
    painter->restore();
  }

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    return scaledPixmap(size, mode, state, 1);
  }

  // `size` is in device pixels already.
  QPixmap scaledPixmap(const QSize& size, QIcon::Mode mode, QIcon::State state, qreal) override {
    QPixmap picture(size);
    if (picture.isNull()) return picture;  // a button that has no room yet
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    paint(&painter, QRect(QPoint(), size), mode, state);
    return picture;
  }

  QIconEngine* clone() const override { return new ToneEngine(*this); }

 private:
  QString name_;
  Tone tone_;
};

}  // namespace

QIcon icon(const QString& name, Tone tone) { return QIcon(new ToneEngine(name, tone)); }

QIcon swatch(const QColor& colour) {
  QPixmap picture(32, 32);
  picture.setDevicePixelRatio(2);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(colour);
  painter.drawRoundedRect(QRectF(2, 2, 12, 12), 3, 3);
  QIcon made(picture);
  made.addPixmap(picture, QIcon::Selected);  // or Fusion tints it in a selected row
  return made;
}

}  // namespace talus::theme
