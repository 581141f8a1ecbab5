#include "widgets/view/view_overlay.hpp"

#include <QPainter>
#include <algorithm>

#include "widgets/kit/theme.hpp"
#include "widgets/view/view_tool.hpp"

namespace talus {

ViewOverlay::ViewOverlay(QWidget* parent) : QWidget(parent) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
  setFocusPolicy(Qt::NoFocus);
}

void ViewOverlay::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  for (auto tool = tools_.rbegin(); tool != tools_.rend(); ++tool) (*tool)->paint(painter);
}

void paintNumberedDot(QPainter& painter, QPointF at, int number) {
  constexpr double radius = 9;
  painter.setPen(QPen(theme::colours().surface, 2));
  painter.setBrush(theme::colours().pick);
  painter.drawEllipse(at, radius, radius);
  painter.setPen(theme::colours().onAccent);
  painter.setFont(theme::font(theme::now().type.small, QFont::DemiBold));
  painter.drawText(QRectF(at.x() - radius, at.y() - radius, 2 * radius, 2 * radius), Qt::AlignCenter,
                   QString::number(number));
}

void paintValueCard(QPainter& painter, QPointF at, const QString& words, QSize view) {
  constexpr double away = 18, padding = 8, height = 24, margin = 4;
  painter.setFont(theme::font(theme::now().type.body, QFont::Medium));
  const double width = painter.fontMetrics().horizontalAdvance(words) + 2 * padding;
  const double x = at.x() + away + width + margin > view.width() ? at.x() - away - width : at.x() + away;
  const QRectF card(x, std::clamp(at.y() - height - 6, margin, view.height() - height - margin), width, height);
  painter.setPen(theme::colours().overlayBorder);
  painter.setBrush(theme::colours().surface);
  painter.drawRoundedRect(card, theme::now().metrics.radiusSmall, theme::now().metrics.radiusSmall);
  painter.setPen(theme::colours().text);
  painter.drawText(card, Qt::AlignCenter, words);
}

}  // namespace talus
