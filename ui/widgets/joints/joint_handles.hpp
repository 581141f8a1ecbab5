#pragma once

#include <QObject>
#include <QString>
#include <optional>

#include "widgets/joints/cut_handles.hpp"
#include "widgets/view/view_tool.hpp"

namespace talus {

class Viewport;
struct Session;

/// The selected cut in the 3-D view of the Joints page, taken hold of by its handles: the joints follow as it is
/// dragged, the project is changed when it is let go, in one step. With Shift values snap; a number that is typed
/// meanwhile counts, Enter takes it, Esc takes all back. A handle that was clicked, or reached with Tab, is moved by
/// the arrow keys. A click on another joint selects it.
class JointHandles : public QObject, public ViewTool {
  Q_OBJECT
 public:
  JointHandles(Session& session, Viewport& viewport);
  ~JointHandles() override;

  /// Where the knob of a handle is in the view, or would be at another value; empty where no cut is selected.
  std::optional<QPointF> knobOf(const CutHandle& handle, std::optional<double> value = {}) const;

  void paint(QPainter& painter) override;
  bool press(QPointF at, Qt::KeyboardModifiers modifiers) override;
  void drag(QPointF at, Qt::KeyboardModifiers modifiers) override;
  void release(QPointF at, Qt::KeyboardModifiers modifiers) override;
  bool click(QPointF at, Qt::KeyboardModifiers modifiers) override;
  bool hover(QPointF at) override;
  void leave() override;
  bool wants(const QKeyEvent& key) const override;
  void key(const QKeyEvent& key) override;

 private:
  /// A handle in the hand.
  struct Grip {
    CutHandle handle;
    Cut before;
    HandleFrame frame;  ///< of `before`
    double under;       ///< value under the pointer when it was taken
    double by = 0;      ///< how far it has gone since
    QString typed{};
    bool moved = false;
  };

  std::optional<int> chosenCut() const;
  std::optional<Cut> shownCut() const;
  HandleFrame frameOf(int index, const Cut& cut) const;
  std::optional<CutHandle> handleAt(QPointF at) const;
  std::optional<QPointF> pointOf(const Vec3& place) const;
  void tryOut(double value);
  void tryCorner(QPointF at, Qt::KeyboardModifiers modifiers);
  void letGo(bool keep);
  void takeTyped();
  void nudge(const QKeyEvent& key);
  void focusNext(int way);
  void change(const Cut& cut, const CutHandle& handle, int gesture);
  void forget();
  void repaint();
  void paintSlide(QPainter& painter, const CutHandle& handle, const Cut& cut, const HandleFrame& frame) const;
  void paintKnob(QPainter& painter, const CutHandle& handle, const Cut& cut, const HandleFrame& frame) const;
  QString words(const CutHandle& handle, const Cut& cut) const;

  Session& session_;
  Viewport& viewport_;
  std::optional<Grip> grip_;
  std::optional<CutHandle> hovered_, focused_;
  std::optional<int> focusedCut_;
  int gesture_ = 0;  ///< of the nudges of the focused handle
};

}  // namespace talus
