#include "widgets/actions/stage_strip.hpp"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "document/things.hpp"
#include "model/stage_length.hpp"
#include "session/current_project.hpp"
#include "session/display.hpp"
#include "session/messages.hpp"
#include "widgets/kit/model_words.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/text.hpp"
#include "widgets/kit/theme.hpp"

namespace talus {

namespace {

constexpr int strip_height = 84, side = 12, axis_height = 18, narrowest = 84;
constexpr double edge_reach = 5, drag_slack = 5;  // pixels

/// s, with the figures that a time needs.
QString seconds(double time) { return QObject::tr("%1 s").arg(numbers::figure(time, 5)); }

QString lengthWords(const Stage& stage) {
  const QString length = seconds(length_of(stage));
  return stage.until_equilibrium ? QObject::tr("at most %1").arg(length) : length;
}

}  // namespace

StageStrip::StageStrip(CurrentProject& project, Messages& messages, Display& display)
    : project_(project), messages_(messages) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setFixedHeight(strip_height);
  setAccessibleName(tr("Stages in time"));
  connect(&project_, &CurrentProject::opened, this, &StageStrip::describe);
  connect(&project_.document(), &Document::projectChanged, this, &StageStrip::describe);
  connect(&project_.selection(), &Selection::changed, this, qOverload<>(&QWidget::update));
  connect(&display, &Display::themeChanged, this, qOverload<>(&QWidget::update));
  describe();
}

QSize StageStrip::sizeHint() const { return {400, strip_height}; }

const std::vector<Stage>& StageStrip::stages() const { return project_.document().project().stages; }

void StageStrip::describe() {
  QStringList all;
  for (int i = 0; i < static_cast<int>(stages().size()); ++i) all << words(i);
  setAccessibleDescription(all.join(u'\n'));
  update();
}

QString StageStrip::words(int stage) const {
  const Stage& one = stages()[static_cast<std::size_t>(stage)];
  const QString changes = words::changes(one);
  return tr("%1: %2, %3; changes %4")
      .arg(text(one.name), words::stage(one.kind), lengthWords(one), changes.isEmpty() ? tr("nothing") : changes);
}

QRectF StageStrip::boxOf(int stage) const {
  const auto& all = stages();
  const double room = width() - 2 * side, least = std::min<double>(narrowest, room / static_cast<double>(all.size()));
  double total = 0;
  for (const Stage& one : all) total += length_of(one);
  const double spare = room - least * static_cast<double>(all.size());
  const auto widthOf = [&](const Stage& one) {
    return least + spare * (total > 0 ? length_of(one) / total : 1 / static_cast<double>(all.size()));
  };
  double left = side;
  for (int i = 0; i < stage; ++i) left += widthOf(all[static_cast<std::size_t>(i)]);
  return {left, axis_height, widthOf(all[static_cast<std::size_t>(stage)]), strip_height - axis_height - 6.0};
}

int StageStrip::stageAt(QPointF place) const {
  for (int i = 0; i < static_cast<int>(stages().size()); ++i)
    if (boxOf(i).contains(place)) return i;
  return -1;
}

int StageStrip::edgeAt(QPointF place) const {
  for (int i = 0; i < static_cast<int>(stages().size()); ++i) {
    const QRectF box = boxOf(i);
    const bool beside = std::abs(box.right() - place.x()) <= edge_reach;
    if (beside && place.y() >= box.top() && place.y() <= box.bottom()) return i;
  }
  return -1;
}

int StageStrip::orderAt(double x) const {
  int order = 0;
  for (int i = 0; i < static_cast<int>(stages().size()); ++i)
    if (i != held_ && boxOf(i).center().x() < x) ++order;
  return order;
}

double StageStrip::lengthAt(double x) const {
  const QRectF box = boxOf(held_);
  const Stage& stage = stages()[static_cast<std::size_t>(held_)];
  const double wanted = length_of(stage) * std::max(0.0, x - box.left()) / box.width();
  return std::max(1.0, std::round(wanted / stage.time_step)) * stage.time_step;
}

void StageStrip::setLength(int index, double length) {
  Document& document = project_.document();
  Project changed = document.project();
  Stage& stage = changed.stages[static_cast<std::size_t>(index)];
  if (stage.steps)
    stage.steps = std::max(1, static_cast<int>(std::lround(length / stage.time_step)));
  else
    stage.duration = std::round(length * 1e9) / 1e9;  // without the digits of rounding
  try {
    document.change(changed, tr("change the length of stage %1").arg(text(stage.name)));
  } catch (const InputError& error) {
    messages_.add(problemOf(error));
  }
}

void StageStrip::move(int stage, int by) {
  if (by == 0) return;
  try {
    things::move(project_.document(), {Item::Kind::stage, stage}, by);
  } catch (const InputError& error) {
    messages_.add(problemOf(error));
  }
}

void StageStrip::select(int stage) { project_.selection().select({Item::Kind::stage, stage}); }

void StageStrip::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  pressed_ = pointer_ = event->position();
  held_ = edgeAt(pressed_);
  drag_ = held_ >= 0 ? Drag::length : Drag::none;
  if (held_ < 0) {
    held_ = stageAt(pressed_);
    if (held_ >= 0) drag_ = Drag::pressed;
  }
  if (held_ >= 0) select(held_);
}

void StageStrip::mouseMoveEvent(QMouseEvent* event) {
  pointer_ = event->position();
  if (drag_ == Drag::none) {
    setCursor(edgeAt(pointer_) >= 0 ? Qt::SplitHCursor : Qt::ArrowCursor);
    return;
  }
  if (drag_ == Drag::pressed && std::abs(pointer_.x() - pressed_.x()) > drag_slack) drag_ = Drag::order;
  update();
}

void StageStrip::mouseReleaseEvent(QMouseEvent* event) {
  pointer_ = event->position();
  const Drag drag = std::exchange(drag_, Drag::none);
  const bool moved = std::abs(pointer_.x() - pressed_.x()) > 1;
  if (drag == Drag::length && moved) setLength(held_, lengthAt(pointer_.x()));
  if (drag == Drag::order) move(held_, orderAt(pointer_.x()) - held_);
  update();
}

void StageStrip::keyPressEvent(QKeyEvent* event) {
  const int way = event->key() == Qt::Key_Right ? 1 : event->key() == Qt::Key_Left ? -1 : 0;
  const int last = static_cast<int>(stages().size()) - 1;
  const Item& current = project_.selection().current();
  if (way == 0 || last < 0) return QWidget::keyPressEvent(event);
  if (current.kind != Item::Kind::stage) return select(way > 0 ? 0 : last);
  const Stage& stage = stages()[static_cast<std::size_t>(current.index)];
  if (event->modifiers().testFlag(Qt::AltModifier))
    move(current.index, way);
  else if (event->modifiers().testFlag(Qt::ControlModifier))
    setLength(current.index, std::max(stage.time_step, length_of(stage) + way * stage.time_step));
  else
    select(std::clamp(current.index + way, 0, last));
}

bool StageStrip::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    const int stage = stageAt(help->pos());
    const QString hint = tr("Drag the right edge to change its length, the stage to change the order");
    QToolTip::showText(help->globalPos(), stage < 0 ? QString() : words(stage) + u'\n' + hint, this);
    return true;
  }
  if (event->type() == QEvent::ShortcutOverride) {  // arrow keys would go from frame to frame
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Left || key == Qt::Key_Right) {
      event->accept();
      return true;
    }
  }
  return QWidget::event(event);
}

void StageStrip::paintEvent(QPaintEvent*) {
  const Colours& c = theme::colours();
  QPainter painter(this);
  painter.fillRect(rect(), c.surface);
  painter.setRenderHint(QPainter::Antialiasing);
  if (stages().empty()) {
    painter.setPen(c.textMuted);
    painter.drawText(rect(), Qt::AlignCenter, tr("The project has no stage: there is nothing to solve."));
    return;
  }
  for (int i = 0; i < static_cast<int>(stages().size()); ++i) paintStage(painter, i);
  painter.setPen(QPen(c.accent, 2));
  if (drag_ == Drag::length) {
    painter.drawLine(QPointF(pointer_.x(), axis_height - 4), QPointF(pointer_.x(), strip_height - 4.0));
    painter.drawText(QRectF(pointer_.x() - 92, 0, 88, axis_height), Qt::AlignRight | Qt::AlignVCenter,
                     seconds(lengthAt(pointer_.x())));
  } else if (drag_ == Drag::order) {
    const int order = orderAt(pointer_.x()), before = order + (order >= held_ ? 1 : 0);
    const bool behind = before >= static_cast<int>(stages().size());
    const double x = behind ? boxOf(static_cast<int>(stages().size()) - 1).right() : boxOf(before).left();
    painter.drawLine(QPointF(x, axis_height - 4), QPointF(x, strip_height - 4.0));
  }
}

void StageStrip::paintStage(QPainter& painter, int index) const {
  const Colours& c = theme::colours();
  const Stage& stage = stages()[static_cast<std::size_t>(index)];
  const QRectF whole = boxOf(index), box = whole.adjusted(1, 0, -1, 0);
  double start = 0;
  for (int i = 0; i < index; ++i) start += length_of(stages()[static_cast<std::size_t>(i)]);
  painter.setFont(theme::font(10));
  painter.setPen(c.textMuted);
  painter.drawText(QRectF(whole.left() + 2, 0, whole.width(), axis_height), Qt::AlignVCenter, seconds(start));
  if (index + 1 == static_cast<int>(stages().size()))
    painter.drawText(QRectF(whole.right() - 90, 0, 88, axis_height), Qt::AlignRight | Qt::AlignVCenter,
                     drag_ == Drag::length ? QString() : seconds(start + length_of(stage)));
  const bool selected = project_.selection().current() == Item{Item::Kind::stage, index};
  painter.setPen(QPen(selected ? c.accent : c.border, selected ? 1.5 : 1));
  painter.setBrush(selected ? c.accentSoft : stage.kind == StageKind::static_ ? c.sunken : c.window);
  painter.drawRoundedRect(box, 5, 5);
  const QRectF inside = box.adjusted(8, 4, -8, -4);
  const auto elided = [&](const QString& words) {
    return painter.fontMetrics().elidedText(words, Qt::ElideRight, static_cast<int>(inside.width()));
  };
  painter.setPen(c.text);
  painter.setFont(theme::font(theme::now().type.body, QFont::DemiBold));
  painter.drawText(QRectF(inside.left(), inside.top(), inside.width(), 16), Qt::AlignVCenter, elided(text(stage.name)));
  painter.setFont(theme::font(theme::now().type.small));
  painter.setPen(c.textMuted);
  painter.drawText(QRectF(inside.left(), inside.top() + 16, inside.width(), 15), Qt::AlignVCenter,
                   elided(tr("%1, %2").arg(words::stage(stage.kind), lengthWords(stage))));
  paintChips(painter, QRectF(inside.left(), inside.top() + 33, inside.width(), 16), words::changeList(stage));
}

/// As many as there is room for, and how many more there are.
void StageStrip::paintChips(QPainter& painter, const QRectF& row, const QStringList& chips) const {
  const Colours& c = theme::colours();
  painter.setFont(theme::font(10));
  const QFontMetrics metrics = painter.fontMetrics();
  double left = row.left();
  for (int i = 0; i < chips.size(); ++i) {
    const QString more = i + 1 < chips.size() ? tr("+%1").arg(chips.size() - i) : QString();
    const double room = row.right() - left;
    const double wanted = metrics.horizontalAdvance(chips[i]) + 10,
                 kept = i == 0 ? 0 : metrics.horizontalAdvance(more) + 14;
    const bool fits = wanted + kept <= room;
    const bool cut = i == 0 && room > 40;
    const QString words = fits  ? chips[i]
                          : cut ? metrics.elidedText(chips[i], Qt::ElideRight, static_cast<int>(room) - 10)
                                : tr("+%1").arg(chips.size() - i);
    const QRectF chip(left, row.top(), std::min(room, metrics.horizontalAdvance(words) + 10.0), row.height());
    painter.setPen(QPen(c.border, 1));
    painter.setBrush(c.surface);
    painter.drawRoundedRect(chip, 4, 4);
    painter.setPen(c.textMuted);
    painter.drawText(chip, Qt::AlignCenter, words);
    if (!fits) return;
    left = chip.right() + 4;
  }
}

}  // namespace talus
