#include "widgets/joints/joint_handles.hpp"

#include <QKeyEvent>
#include <QLineF>
#include <QPainter>
#include <QPolygonF>
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "orientation/cut_moves.hpp"
#include "session/session.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/theme.hpp"
#include "widgets/view/view_overlay.hpp"
#include "widgets/view/viewport.hpp"

namespace talus {

namespace {

constexpr double ring_radius = 72, knob = 5.5, knob_reach = 8;  // pixels
constexpr double free_angle = 0.1, snapped_angle = 5;           // degrees
constexpr double free_length = 0.01, snapped_length = 0.5;      // m
constexpr double nudged_angle = 1, nudged_length = 0.1;

bool isAngle(const CutHandle& handle) {
  return handle.kind == CutHandle::Kind::direction || handle.kind == CutHandle::Kind::dip;
}

double rounded(double value, const CutHandle& handle, bool snaps) {
  const double step = isAngle(handle) ? (snaps ? snapped_angle : free_angle) : snaps ? snapped_length : free_length;
  const double inverse = 1 / step;  // 451 / 10 is 45.1, 451 · 0.1 is not
  return std::round(value * inverse) / inverse;
}

/// The step as the undo list calls it.
QString stepName(const CutHandle& handle, int cut) {
  switch (handle.kind) {
    case CutHandle::Kind::move:
      return QObject::tr("move cut %1").arg(cut + 1);
    case CutHandle::Kind::radius:
      return QObject::tr("size cut %1").arg(cut + 1);
    case CutHandle::Kind::corner:
      return QObject::tr("move a corner of cut %1").arg(cut + 1);
    case CutHandle::Kind::direction:
    case CutHandle::Kind::dip:
      break;
  }
  return QObject::tr("turn cut %1").arg(cut + 1);
}

bool isTyped(const QKeyEvent& key) {
  return !key.text().isEmpty() && QStringLiteral("0123456789.,-−").contains(key.text());
}

}  // namespace

JointHandles::JointHandles(Session& session, Viewport& viewport)
    : QObject(&viewport), session_(session), viewport_(viewport) {
  connect(&session_.project.selection(), &Selection::changed, this, &JointHandles::forget);
  connect(&session_.project, &CurrentProject::opened, this, &JointHandles::forget);
  connect(&session_.display, &Display::pageChanged, this, &JointHandles::forget);
  connect(&session_.display, &Display::changed, this, &JointHandles::repaint);
  connect(&session_.joints, &DrawnJoints::changed, this, &JointHandles::repaint);
  connect(&session_.picking, &Picking::changed, this, &JointHandles::repaint);
  viewport_.overlay().add(*this);
}

JointHandles::~JointHandles() = default;

void JointHandles::repaint() { viewport_.overlay().update(); }

void JointHandles::forget() {
  letGo(false);
  hovered_.reset();
  if (focusedCut_ != chosenCut()) focused_.reset();
  focusedCut_ = chosenCut();
  repaint();
}

std::optional<int> JointHandles::chosenCut() const {
  const Item& current = session_.project.selection().current();
  const bool isThere = current.kind == Item::Kind::cut && current.index >= 0 &&
                       current.index < static_cast<int>(session_.project.document().project().cuts.size());
  if (!isThere || !viewport_.showsJoints() || session_.picking.isAsking()) return std::nullopt;
  return current.index;
}

std::optional<Cut> JointHandles::shownCut() const {
  const auto index = chosenCut();
  if (!index) return std::nullopt;
  return session_.joints.cuts().at(static_cast<std::size_t>(*index));
}

/// At `through` where that is in the rock; else in the middle of what is drawn of the plane.
HandleFrame JointHandles::frameOf(int index, const Cut& cut) const {
  HandleFrame frame;
  frame.centre = cut.through;
  const bool ends = cut.disc || !cut.polygon.empty() || cut.network;
  const auto box = viewport_.extent();
  if (!ends && box && !box->contains(cut.through))
    if (const auto middle = session_.joints.middleOf(index)) frame.centre = *middle;
  frame.radius = ring_radius * viewport_.metresPerPixel(frame.centre);
  return frame;
}

std::optional<QPointF> JointHandles::pointOf(const Vec3& place) const { return viewport_.pointOf(place); }

std::optional<QPointF> JointHandles::knobOf(const CutHandle& handle, std::optional<double> value) const {
  const auto cut = shownCut();
  if (!cut) return std::nullopt;
  return pointOf(knobPlace(handle, *cut, frameOf(*chosenCut(), *cut), value.value_or(valueOf(handle, *cut))));
}

std::optional<CutHandle> JointHandles::handleAt(QPointF at) const {
  const auto cut = shownCut();
  if (!cut) return std::nullopt;
  std::optional<CutHandle> found;
  double least = knob_reach;
  for (const CutHandle& handle : handlesOf(*cut)) {
    const auto place = knobOf(handle);
    const double away = place ? QLineF(*place, at).length() : knob_reach + 1;
    if (away > least) continue;
    least = away;
    found = handle;
  }
  return found;
}

bool JointHandles::press(QPointF at, Qt::KeyboardModifiers) {
  const auto handle = handleAt(at);
  if (!handle) return false;
  const Cut cut = *shownCut();
  const HandleFrame frame = frameOf(*chosenCut(), cut);
  const double value = valueOf(*handle, cut);
  grip_ = Grip{*handle, cut, frame,
               valueUnder(*handle, cut, frame, at, value, [this](const Vec3& p) { return pointOf(p); })};
  if (focused_ != handle) gesture_ = session_.project.document().newGesture();
  focused_ = handle;
  repaint();
  return true;
}

void JointHandles::drag(QPointF at, Qt::KeyboardModifiers modifiers) {
  if (!grip_ || !grip_->typed.isEmpty()) return;
  if (grip_->handle.kind == CutHandle::Kind::corner) return tryCorner(at, modifiers);
  const double before = valueOf(grip_->handle, grip_->before);
  const double under = valueUnder(grip_->handle, grip_->before, grip_->frame, at, grip_->under + grip_->by,
                                  [this](const Vec3& p) { return pointOf(p); });
  grip_->by = under - grip_->under;
  tryOut(rounded(before + grip_->by, grip_->handle, modifiers.testFlag(Qt::ShiftModifier)));
}

void JointHandles::tryOut(double value) {
  grip_->moved = true;
  session_.joints.tryOut(*chosenCut(), withValue(grip_->before, grip_->handle, value, grip_->frame.centre));
}

void JointHandles::tryCorner(QPointF at, Qt::KeyboardModifiers modifiers) {
  const auto sight = viewport_.sightAt(at);
  const auto place = sight ? onPlane(grip_->before, *sight) : std::nullopt;
  if (!place) return;
  Vec3 corner = *place;
  if (modifiers.testFlag(Qt::ShiftModifier))
    for (int axis = 0; axis < 3; ++axis) corner[axis] = rounded(corner[axis], grip_->handle, true);
  grip_->moved = true;
  session_.joints.tryOut(*chosenCut(),
                         with_corner(grip_->before, static_cast<std::size_t>(grip_->handle.corner), corner));
}

void JointHandles::release(QPointF, Qt::KeyboardModifiers) {
  if (grip_ && !grip_->typed.isEmpty()) takeTyped();
  letGo(true);
}

void JointHandles::letGo(bool keep) {
  if (!grip_) return;
  const auto cut = shownCut();
  const Grip grip = *std::exchange(grip_, std::nullopt);
  if (keep && grip.moved && cut) change(*cut, grip.handle, session_.project.document().newGesture());
  session_.joints.endTrial();
  repaint();
}

void JointHandles::change(const Cut& cut, const CutHandle& handle, int gesture) {
  Project changed = session_.project.document().project();
  const int index = *chosenCut();
  changed.cuts.at(static_cast<std::size_t>(index)) = cut;
  try {
    session_.project.document().change(changed, stepName(handle, index), gesture);
  } catch (const InputError& error) {
    session_.messages.add(problemOf(error));
  }
}

bool JointHandles::click(QPointF at, Qt::KeyboardModifiers) {
  const auto cut = viewport_.jointAt(at);
  if (!cut || session_.picking.isAsking()) return false;
  session_.project.selection().select({Item::Kind::cut, *cut});
  return true;
}

bool JointHandles::hover(QPointF at) {
  const auto before = std::exchange(hovered_, handleAt(at));
  if (before != hovered_) {
    viewport_.usePointer(hovered_ ? Qt::PointingHandCursor : Qt::ArrowCursor);
    repaint();
  }
  return hovered_.has_value();
}

void JointHandles::leave() {
  hovered_.reset();
  repaint();
}

bool JointHandles::wants(const QKeyEvent& key) const {
  const bool isCommand = key.modifiers() & (Qt::ControlModifier | Qt::AltModifier);
  if (isCommand || !chosenCut()) return false;
  switch (key.key()) {
    case Qt::Key_Escape:
      return grip_ || focused_;
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Backspace:
      return grip_.has_value();
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Up:
    case Qt::Key_Down:
      return focused_ && !grip_;
    case Qt::Key_Tab:
      return !grip_ && focused_ != std::optional(handlesOf(*shownCut()).back());
    case Qt::Key_Backtab:
      return !grip_ && focused_.has_value();
    default:
      return grip_ && grip_->handle.kind != CutHandle::Kind::corner && isTyped(key);
  }
}

void JointHandles::key(const QKeyEvent& key) {
  switch (key.key()) {
    case Qt::Key_Escape:
      if (grip_)
        letGo(false);
      else
        focused_.reset();
      break;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (!grip_->typed.isEmpty()) takeTyped();
      letGo(true);
      break;
    case Qt::Key_Backspace:
      grip_->typed.chop(1);
      takeTyped();
      break;
    case Qt::Key_Tab:
      focusNext(1);
      break;
    case Qt::Key_Backtab:
      focusNext(-1);
      break;
    default:
      if (grip_) {
        grip_->typed += key.text();
        takeTyped();
      } else {
        nudge(key);
      }
  }
  repaint();
}

/// What has been typed so far counts, as far as it is a number.
void JointHandles::takeTyped() {
  bool isNumber = false;
  QString text = grip_->typed;
  const double value = text.replace(u',', u'.').replace(u'−', u'-').toDouble(&isNumber);
  if (isNumber) tryOut(value);
}

void JointHandles::nudge(const QKeyEvent& key) {
  const bool more = key.key() == Qt::Key_Right || key.key() == Qt::Key_Up, far = key.modifiers() & Qt::ShiftModifier;
  const double sign = more ? 1 : -1;
  const Cut cut = *shownCut();
  if (focused_->kind == CutHandle::Kind::corner) {
    const auto corner = static_cast<std::size_t>(focused_->corner);
    const bool sideways = key.key() == Qt::Key_Left || key.key() == Qt::Key_Right;
    const Vec3 down = dip_vector_of({cut.dip, cut.dip_direction});
    const Vec3 along = direction_of({0, cut.dip_direction - 90});
    const Vec3 by = sign * (far ? snapped_length : nudged_length) * (sideways ? along : Vec3(-down));
    change(with_corner(cut, corner, cut.polygon.at(corner) + by), *focused_, gesture_);
    return;
  }
  const double by = isAngle(*focused_) ? (far ? snapped_angle : nudged_angle) : far ? snapped_length : nudged_length;
  const Vec3 pivot = frameOf(*chosenCut(), cut).centre;
  change(withValue(cut, *focused_, valueOf(*focused_, cut) + sign * by, pivot), *focused_, gesture_);
}

void JointHandles::focusNext(int way) {
  const std::vector<CutHandle> handles = handlesOf(*shownCut());
  const auto now = focused_ ? std::ranges::find(handles, *focused_) : handles.end();
  const auto count = static_cast<std::ptrdiff_t>(handles.size());
  const std::ptrdiff_t next = now == handles.end() ? (way > 0 ? 0 : count - 1) : now - handles.begin() + way;
  focused_.reset();
  if (next >= 0 && next < count) focused_ = handles[static_cast<std::size_t>(next)];
  gesture_ = session_.project.document().newGesture();
}

void JointHandles::paint(QPainter& painter) {
  const auto cut = shownCut();
  if (!cut) return;
  const HandleFrame frame = frameOf(*chosenCut(), *cut);
  const std::vector<CutHandle> handles = handlesOf(*cut);
  for (const CutHandle& handle : handles) paintSlide(painter, handle, *cut, frame);
  for (const CutHandle& handle : handles) paintKnob(painter, handle, *cut, frame);
  const auto told = grip_ ? std::optional(grip_->handle) : hovered_ ? hovered_ : focused_;
  const auto at = told ? knobOf(*told) : std::nullopt;
  if (at) paintValueCard(painter, *at, words(*told, *cut), viewport_.size());
}

void JointHandles::paintSlide(QPainter& painter, const CutHandle& handle, const Cut& cut,
                              const HandleFrame& frame) const {
  QPolygonF line;
  for (const Vec3& place : slideOf(handle, cut, frame))
    if (const auto at = pointOf(place)) line << *at;
  const bool strong = handle == hovered_ || handle == focused_ || (grip_ && grip_->handle == handle);
  QColor halo = theme::colours().surface;
  halo.setAlphaF(0.7F);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(halo, strong ? 5 : 4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPolyline(line);
  painter.setPen(QPen(theme::colours().pick, strong ? 2.5 : 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPolyline(line);
}

void JointHandles::paintKnob(QPainter& painter, const CutHandle& handle, const Cut& cut,
                             const HandleFrame& frame) const {
  const auto at = pointOf(knobPlace(handle, cut, frame, valueOf(handle, cut)));
  if (!at) return;
  const bool held = grip_ && grip_->handle == handle, strong = held || handle == hovered_;
  painter.setPen(QPen(theme::colours().surface, 2));
  painter.setBrush(theme::colours().pick);
  const double size = strong ? knob + 1.5 : knob;
  const auto foot = pointOf(frame.centre);
  if (handle.kind == CutHandle::Kind::move && foot) {
    const QLineF shaft(*foot, *at);
    QLineF side = shaft.normalVector().unitVector(), ahead = shaft.unitVector();
    const QPointF across(side.dx() * size, side.dy() * size), tip(ahead.dx() * size, ahead.dy() * size);
    painter.drawPolygon(QPolygonF{*at + 1.6 * tip, *at - tip + across, *at - tip - across});
  } else if (handle.kind == CutHandle::Kind::corner) {
    painter.drawRect(QRectF(at->x() - size, at->y() - size, 2 * size, 2 * size));
  } else {
    painter.drawEllipse(*at, size, size);
  }
  if (handle != focused_) return;
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(theme::colours().accent, 1.5));
  painter.drawEllipse(*at, size + 4, size + 4);
}

QString JointHandles::words(const CutHandle& handle, const Cut& cut) const {
  if (grip_ && grip_->handle == handle && !grip_->typed.isEmpty()) {
    const QString unit = isAngle(handle) ? QStringLiteral("°") : QStringLiteral(" m");
    return grip_->typed + unit + tr("   Enter");
  }
  switch (handle.kind) {
    case CutHandle::Kind::direction:
      return tr("dip direction %1°").arg(numbers::fixed(cut.dip_direction, 1));
    case CutHandle::Kind::dip:
      return tr("dip %1°").arg(numbers::fixed(cut.dip, 1));
    case CutHandle::Kind::radius:
      return tr("radius %1 m").arg(numbers::fixed(valueOf(handle, cut), 2));
    case CutHandle::Kind::corner: {
      const Vec3& place = cut.polygon.at(static_cast<std::size_t>(handle.corner));
      return tr("corner %1: %2, %3, %4 m")
          .arg(handle.corner + 1)
          .arg(numbers::fixed(place.x(), 2), numbers::fixed(place.y(), 2), numbers::fixed(place.z(), 2));
    }
    case CutHandle::Kind::move:
      break;
  }
  if (!grip_) return tr("move along the normal");
  const double by = normal_of(cut).dot(cut.through - grip_->before.through);
  return tr("%1%2 m").arg(by < 0 ? QStringLiteral("−") : QStringLiteral("+"), numbers::fixed(std::abs(by), 2));
}

}  // namespace talus
