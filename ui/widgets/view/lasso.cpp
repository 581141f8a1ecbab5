#include "widgets/view/lasso.hpp"

#include <QPainter>
#include <utility>

#include "widgets/kit/theme.hpp"

namespace talus {

namespace {

constexpr double least_step = 3;  // pixels between corners: a hand draws no finer
constexpr double tint = 0.12;

}  // namespace

Lasso::Lasso(QWidget* view) : QWidget(view) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  hide();
}

void Lasso::begin(QPointF at) {
  outline_ = {at};
  setGeometry(parentWidget()->rect());
  raise();
  show();
}

void Lasso::extend(QPointF to) {
  if ((to - outline_.last()).manhattanLength() < least_step) return;
  outline_ << to;
  update();
}

QPolygonF Lasso::take() {
  hide();
  return std::exchange(outline_, {});
}

void Lasso::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QColor inside = theme::colours().pick;
  painter.setPen(QPen(inside, 1.5));
  inside.setAlphaF(tint);
  painter.setBrush(inside);
  painter.drawPolygon(outline_);
}

}  // namespace talus
