// What the mouse does in the 3-D view: turn, pan, zoom, pick.
#include <QLabel>
#include <QMouseEvent>
#include <QRubberBand>
#include <QWheelEvent>
#include <algorithm>
#include <array>
#include <cmath>

#include "document/selection.hpp"
#include "removability/block_rule.hpp"
#include "session/workflow_page.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/text.hpp"
#include "widgets/view/lasso.hpp"
#include "widgets/view/render_surface.hpp"
#include "widgets/view/view_overlay.hpp"
#include "widgets/view/view_tool.hpp"
#include "widgets/view/viewport.hpp"

namespace talus {

namespace {

constexpr double turn_per_pixel = 0.35;  // degrees
constexpr double zoom_per_notch = 0.85;
constexpr double click_slack = 4;  // pixels that a hand moves in a click

}  // namespace

bool Viewport::eventFilter(QObject* watched, QEvent* event) {
  if (watched != surface_->widget() || !scene_) return QWidget::eventFilter(watched, event);
  switch (event->type()) {
    case QEvent::MouseButtonPress:
      return mousePressed(*static_cast<QMouseEvent*>(event));
    case QEvent::MouseMove:
      return mouseMoved(*static_cast<QMouseEvent*>(event));
    case QEvent::MouseButtonRelease:
      return mouseReleased(*static_cast<QMouseEvent*>(event));
    case QEvent::Wheel:
      return wheelTurned(*static_cast<QWheelEvent*>(event));
    case QEvent::ShortcutOverride:
    case QEvent::KeyPress:
      return keyPressed(event);
    case QEvent::Leave:
      hoverTimer_.stop();
      for (ViewTool* tool : overlay_->tools()) tool->leave();
      selection().hover();
      if (tellsOfRun()) card_->hide();
      emit pointedAt({});
      return false;
    default:
      return false;
  }
}

bool Viewport::mousePressed(const QMouseEvent& event) {
  flight_.stop();
  pressed_ = last_ = event.position();
  moved_ = false;
  const bool left = event.button() == Qt::LeftButton;
  surface_->widget()->setFocus(Qt::MouseFocusReason);
  hoverTimer_.stop();
  if (left && toolTakes(event)) return true;
  drag_ = dragOf(event);
  if (drag_ == Drag::lasso) lasso_->begin(pressed_);
  return true;
}

bool Viewport::toolTakes(const QMouseEvent& event) {
  const auto& tools = overlay_->tools();
  const auto taker =
      std::ranges::find_if(tools, [&](ViewTool* tool) { return tool->press(event.position(), event.modifiers()); });
  if (taker == tools.end()) return false;
  taken_ = *taker;
  drag_ = Drag::tool;
  return true;
}

bool Viewport::keyPressed(QEvent* event) {
  const auto& key = *static_cast<QKeyEvent*>(event);
  const auto& tools = overlay_->tools();
  const auto taker = std::ranges::find_if(tools, [&](const ViewTool* tool) { return tool->wants(key); });
  if (taker == tools.end()) return false;
  if (event->type() == QEvent::KeyPress) (*taker)->key(key);
  event->accept();
  return true;
}

Viewport::Drag Viewport::dragOf(const QMouseEvent& event) const {
  if (event.button() == Qt::MiddleButton) return Drag::pan;
  if (event.button() != Qt::LeftButton) return Drag::none;
  if (event.modifiers().testFlag(Qt::AltModifier)) return Drag::lasso;
  if (event.modifiers().testFlag(Qt::ShiftModifier)) return drawsLasso_ ? Drag::lasso : Drag::box;
  return Drag::turn;
}

bool Viewport::mouseMoved(const QMouseEvent& event) {
  const QPointF by = event.position() - last_;
  if (drag_ == Drag::none) {
    last_ = event.position();
    if (!isRunning() && !hoverTimer_.isActive()) hoverTimer_.start();
    return true;
  }
  if (drag_ == Drag::tool) {
    taken_->drag(event.position(), event.modifiers());
    return true;
  }
  moved_ = moved_ || (event.position() - pressed_).manhattanLength() > click_slack;
  if (!moved_) return true;
  last_ = event.position();
  if (drag_ == Drag::box) {
    band_->setGeometry(QRectF(pressed_, last_).normalized().toRect());
    band_->show();
  } else if (drag_ == Drag::lasso) {
    lasso_->extend(last_);
  } else if (drag_ == Drag::turn) {
    moveCamera(turned(scene_->pose(), -by.x() * turn_per_pixel, by.y() * turn_per_pixel));
  } else {
    moveCamera(panned(scene_->pose(), by, size()));
  }
  return true;
}

bool Viewport::mouseReleased(const QMouseEvent& event) {
  if (drag_ == Drag::tool) {
    drag_ = Drag::none;
    taken_->release(event.position(), event.modifiers());
    stillTimer_.start();
    return true;
  }
  const bool clicked = drag_ != Drag::none && !moved_ && event.button() == Qt::LeftButton;
  const bool boxed = drag_ == Drag::box && moved_, drawn = drag_ == Drag::lasso && moved_;
  const bool added = event.modifiers().testFlag(Qt::ControlModifier);
  if (event.button() == Qt::RightButton) return menuAsked(event), true;
  drag_ = Drag::none;
  band_->hide();
  const QPolygonF around = lasso_->take();
  if (boxed) selectIn(QRectF(pressed_, event.position()).normalized(), event.position().x() < pressed_.x(), added);
  if (drawn) selectIn(around, false, added);
  if (clicked && !toolClicked(event)) selectAt(event.position(), event.modifiers());
  stillTimer_.start();
  return true;
}

bool Viewport::toolClicked(const QMouseEvent& event) {
  return std::ranges::any_of(overlay_->tools(),
                             [&](ViewTool* tool) { return tool->click(event.position(), event.modifiers()); });
}

/// A right click on something that is not selected selects it first.
void Viewport::menuAsked(const QMouseEvent& event) {
  const auto pick = pickAt(event.position());
  const auto chosen = selectedInView();
  if (pick && std::ranges::count(chosen, pick->block) == 0) selection().select(itemOf(pick->block));
  emit menuWanted(event.globalPosition().toPoint());
}

bool Viewport::wheelTurned(const QWheelEvent& event) {
  flight_.stop();
  const double notches = event.angleDelta().y() / 120.0;  // touch pads send fractions
  if (notches != 0) moveCamera(zoomed(scene_->pose(), std::pow(zoom_per_notch, notches), event.position(), size()));
  return true;
}

void Viewport::pickForHover() {
  if (std::ranges::any_of(overlay_->tools(), [this](ViewTool* tool) { return tool->hover(last_); })) {
    selection().hover();
    return;
  }
  const auto pick = pickAt(last_);
  selection().hover(pick ? itemOf(pick->block) : Item{});
  emit pointedAt(pick ? surveyedPlace(*pick) : QString());
  if (!showsSolids_ && !tellsOfRun()) return;
  if (pick)
    showCard(*pick, last_);
  else
    card_->hide();
}

void Viewport::selectIn(const QPolygonF& outline, bool touched, bool added) {
  if (isStale()) return;
  const double ratio = devicePixelRatioF();
  std::vector<std::array<double, 2>> corners;
  for (const QPointF& corner : outline) corners.push_back({corner.x() * ratio, corner.y() * ratio});
  std::vector<int> blocks = scene_->blocks_in(corners, touched);
  Selection& shared = selection();
  if (showsSolids_)
    for (int& block : blocks) block = itemOf(block).index;
  if (added) blocks = combined(showsSolids_ ? shared.solids() : shared.blocks(), blocks, Combination::add);
  if (showsSolids_)
    shared.selectSolids(std::move(blocks));
  else
    shared.selectBlocks(std::move(blocks));
}

Item Viewport::itemOf(int block) const {
  if (!showsSolids_) return {Item::Kind::block, block};
  return {Item::Kind::solid, system_->blocks[static_cast<std::size_t>(block)].solid};
}

std::vector<int> Viewport::selectedInView() const {
  if (isStale()) return {};
  const Selection& shared = selection();
  if (!shared.blocks().empty()) return showsSolids_ ? std::vector<int>{} : shared.blocks();
  std::vector<int> chosen;
  for (std::size_t b = 0; system_ && b < system_->blocks.size(); ++b)
    if (std::ranges::count(shared.solids(), system_->blocks[b].solid) > 0) chosen.push_back(static_cast<int>(b));
  return chosen;
}

std::optional<int> Viewport::hoveredInView() const {
  if (isStale()) return std::nullopt;
  const Selection& shared = selection();
  if (!showsSolids_) return shared.hoveredBlock();
  for (std::size_t b = 0; b < system_->blocks.size(); ++b)
    if (system_->blocks[b].solid == shared.hoveredSolid()) return static_cast<int>(b);
  return std::nullopt;
}

void Viewport::selectAt(QPointF point, Qt::KeyboardModifiers modifiers) {
  if (selectActionAt(point)) return;
  const auto pick = pickAt(point);
  if (!pick || pick->block < 0) {
    selection().clear();
    return;
  }
  const Item item = itemOf(pick->block);
  if (!modifiers.testFlag(Qt::ControlModifier))
    selection().select(item);
  else if (showsSolids_)
    selection().toggleSolid(item.index);
  else
    selection().toggleBlock(item.index);
  showCard(*pick, point);
}

QString Viewport::surveyedPlace(const Pick& pick) const {
  const Vec3 surveyed = pick.position + project().origin;
  return tr("E %1  N %2  Z %3 m")
      .arg(numbers::fixed(surveyed.x(), 1), numbers::fixed(surveyed.y(), 1), numbers::fixed(surveyed.z(), 1));
}

/// A frame of a run is in view, on the pages that tell of one.
bool Viewport::tellsOfRun() const { return page() == WorkflowPage::results && shownFrame(); }

/// The joint that the face lies on, the element behind it, and of several blocks that are selected their volume.
QString Viewport::wordsOfPick(const Pick& pick) const {
  const Block& block = system_->blocks[static_cast<std::size_t>(pick.block)];
  const int joint = block.surface[static_cast<std::size_t>(pick.facet)].joint;
  const bool isNamed = joint >= 0 && joint < static_cast<int>(system_->joint_names.size());
  QString words = isNamed ? tr("Face on joint %1").arg(text(system_->joint_names[static_cast<std::size_t>(joint)]))
                          : tr("Face on no joint");
  words += u'\n' + tr("Element %1, node %2").arg(pick.tetrahedron).arg(pick.node);
  const std::vector<int>& chosen = selection().blocks();
  double volume = 0;
  for (const int one : chosen) volume += system_->blocks[static_cast<std::size_t>(one)].volume;
  if (chosen.size() > 1)
    words +=
        u'\n' + tr("%1 selected: %2 m³").arg(numbers::counted(chosen.size(), "block"), numbers::significant(volume, 4));
  return words;
}

void Viewport::showCard(const Pick& pick, QPointF point) {
  const Block& block = system_->blocks[static_cast<std::size_t>(pick.block)];
  cardTitle_->setText(text(block.name));
  QString words = surveyedPlace(pick);
  if (showsSolids_) words = tr("%1 m³").arg(numbers::significant(block.volume, 4)) + u'\n' + words;
  if (pick.value && displayed().field) {
    const Field& field = *displayed().field;
    const std::string unit(field.unit);
    words = tr("%1 %2").arg(text(field.title), numbers::quantity(*pick.value, unit.c_str())) + u'\n' + words;
  }
  if (tellsOfRun()) words = wordsOfPick(pick) + u'\n' + words;
  cardText_->setText(words);
  card_->adjustSize();
  const int x = std::clamp(static_cast<int>(point.x()) + 16, 4, std::max(4, width() - card_->width() - 8));
  const int y = std::clamp(static_cast<int>(point.y()) - 24, 4, std::max(4, height() - card_->height() - 8));
  card_->move(x, y);
  card_->show();
  card_->raise();
}

}  // namespace talus
