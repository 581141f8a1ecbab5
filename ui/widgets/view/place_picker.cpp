#include "widgets/view/place_picker.hpp"

#include <QLabel>
#include <QPainter>

#include "session/picking.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/view/view_overlay.hpp"
#include "widgets/view/viewport.hpp"

namespace talus {

PlacePicker::PlacePicker(Picking& picking, Viewport& viewport)
    : QFrame(&viewport), picking_(picking), viewport_(viewport) {
  setProperty("plane", "overlay");
  setObjectName(QStringLiteral("picking"));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(10, 4, 4, 4);
  row->setSpacing(8);
  row->addWidget(new Glyph(QStringLiteral("point"), theme::Tone::accent));
  words_ = makeLabel({}, "strong");
  row->addWidget(words_);
  row->addWidget(makeLabel(tr("Esc ends it"), "small"));
  auto* end = makeTool(QStringLiteral("close"), tr("End picking (Esc)"));
  connect(end, &QToolButton::clicked, &picking_, &Picking::cancel);
  row->addWidget(end);
  connect(&picking_, &Picking::changed, this, &PlacePicker::follow);
  hide();
}

void PlacePicker::follow() {
  const bool asks = picking_.isAsking();
  setVisible(asks);
  if (asks) {
    const auto next = picking_.soFar().size() + 1;
    words_->setText(picking_.wanted() == 1
                        ? picking_.prompt()
                        : tr("%1 of %2: %3").arg(next).arg(picking_.wanted()).arg(picking_.prompt()));
  } else {
    viewport_.markFace({});
  }
  viewport_.usePointer(asks ? Qt::CrossCursor : Qt::ArrowCursor);
  viewport_.placeOverlays();
}

void PlacePicker::paint(QPainter& painter) {
  int number = 0;
  for (const PickedPlace& place : picking_.soFar()) {
    ++number;
    if (const auto at = viewport_.pointOf(place)) paintNumberedDot(painter, *at, number);
  }
}

bool PlacePicker::click(QPointF at, Qt::KeyboardModifiers) {
  if (!picking_.isAsking()) return false;
  if (const auto pick = viewport_.pickAt(at)) picking_.take(viewport_.placeOf(*pick));
  return true;
}

bool PlacePicker::hover(QPointF at) {
  if (!picking_.isAsking()) return false;
  viewport_.markFace(viewport_.pickAt(at));
  return true;
}

void PlacePicker::leave() { viewport_.markFace({}); }

}  // namespace talus
