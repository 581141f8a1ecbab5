#pragma once

#include <QPointF>
#include <Qt>

class QKeyEvent;
class QPainter;

namespace talus {

/// Something that is worked with by hand in the 3-D view and drawn over its picture. The view asks its tools first;
/// what none of them takes turns the camera or selects. Points are logical pixels from the view's upper left corner.
class ViewTool {
 public:
  virtual ~ViewTool() = default;

  virtual void paint(QPainter& painter) = 0;
  /// The left button goes down: true takes the drag that follows, until `release` or `leave`.
  virtual bool press(QPointF, Qt::KeyboardModifiers) { return false; }
  virtual void drag(QPointF, Qt::KeyboardModifiers) {}
  virtual void release(QPointF, Qt::KeyboardModifiers) {}
  /// A click that nobody took as a drag.
  virtual bool click(QPointF, Qt::KeyboardModifiers) { return false; }
  /// The pointer rests, no button is down; true: nothing else under it lights up.
  virtual bool hover(QPointF) { return false; }
  /// The pointer has left the view.
  virtual void leave() {}
  /// It would take this key, which then is no shortcut of the window.
  virtual bool wants(const QKeyEvent&) const { return false; }
  virtual void key(const QKeyEvent&) {}
};

}  // namespace talus
