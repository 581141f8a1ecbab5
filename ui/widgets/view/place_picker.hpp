#pragma once

#include <QFrame>

#include "widgets/view/view_tool.hpp"

class QLabel;

namespace talus {

class Picking;
class Viewport;
struct Pick;
struct PickedPlace;

/// Takes clicks for whoever asks for places: a strip says what is asked for, the face under the pointer is marked,
/// places that were clicked are numbered. The camera can be turned meanwhile; Esc or the strip's button ends it.
class PlacePicker : public QFrame, public ViewTool {
  Q_OBJECT
 public:
  PlacePicker(Picking& picking, Viewport& viewport);

  void paint(QPainter& painter) override;
  bool click(QPointF at, Qt::KeyboardModifiers modifiers) override;
  bool hover(QPointF at) override;
  void leave() override;

 private:
  void follow();

  Picking& picking_;
  Viewport& viewport_;
  QLabel* words_;
};

}  // namespace talus
